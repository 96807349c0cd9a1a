#pragma once

#include <map>
#include <string_view>

namespace glissade {

/// French for what work instructions say and no report does.
const std::map<std::string_view, std::string_view>& instructionFrench();

}  // namespace glissade
