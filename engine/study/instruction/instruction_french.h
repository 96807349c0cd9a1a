#pragma once

#include <map>
#include <string_view>

namespace glissade {

/// French for the texts of work instructions that no report has.
const std::map<std::string_view, std::string_view>& instructionFrench();

}  // namespace glissade
