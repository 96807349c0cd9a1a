#pragma once

#include <string>
#include <vector>

#include "engine/assembly/product.h"
#include "engine/base/result.h"

namespace glissade {

/// Which of the bodies a person means by these names: a body whose id ends in one, or all bodies of an assembly whose
/// path ends in one. Errors: Usage with `option` as place, where a name means no body or where nothing remains.
Result<std::vector<bool>> bodiesMeant(const std::vector<std::string>& ids, const std::vector<std::string>& names,
                                      const std::string& option);
/// The same; a name that means no body by its id means the bodies of the nodes of that name.
Result<std::vector<bool>> bodiesMeant(const std::vector<std::string>& ids, const std::vector<std::string>& names,
                                      const std::string& option, const Product& product);

/// Numbers of the bodies that one name means, ascending: by their ids, or else by the tree.
std::vector<std::size_t> bodiesMeant(const std::vector<std::string>& ids, const std::string& name,
                                     const Product& product);

}  // namespace glissade
