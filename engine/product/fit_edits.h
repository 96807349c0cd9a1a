#pragma once

#include <string>

#include "engine/product/fit_settings.h"

namespace glissade {

/// What a person says about this pair of bodies, by id in either order; a new entry where nothing was said.
FitEdit& editOf(const std::string& a, const std::string& b, FitSettings& settings);

}  // namespace glissade
