#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"

namespace glissade {

/// Which of the bodies a person means by these names: a body whose id ends in one, or all bodies of an assembly whose
/// path ends in one. Errors: Usage with `option` as place, where a name means no body or where nothing remains.
Result<std::vector<bool>> bodiesMeant(const std::vector<std::string>& ids, const std::vector<std::string>& names,
                                      const std::string& option);

}  // namespace glissade
