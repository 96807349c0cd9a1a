#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/model/body_id.h"
#include "engine/model/product.h"

namespace glissade {

/// For each body, whether a person means it by one of the names: its id ends in the name, or it is in an assembly whose
/// path ends in it. Errors: Usage with `option` as place, for a name of no body, or if no body remains.
Result<std::vector<bool>> bodiesMeant(const std::vector<BodyId>& ids, const std::vector<std::string>& names,
                                      const std::string& option);
/// A name that is no id of a body also means the bodies of the nodes with that name.
Result<std::vector<bool>> bodiesMeant(const std::vector<BodyId>& ids, const std::vector<std::string>& names,
                                      const std::string& option, const Product& product);

/// Numbers of the bodies that one name means, ascending: by their ids, or else by the tree.
std::vector<std::size_t> bodiesMeant(const std::vector<BodyId>& ids, const std::string& name, const Product& product);

}  // namespace glissade
