#pragma once

#include <map>
#include <string_view>

namespace glissade {

/// French for what reports say and for the texts of the papers' studies (samples/studies).
const std::map<std::string_view, std::string_view>& studyFrench();

}  // namespace glissade
