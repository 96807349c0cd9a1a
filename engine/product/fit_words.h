#pragma once

#include <string>

#include "engine/check/product.h"
#include "engine/product/fit_settings.h"

namespace glissade {

/// What a person says about a pair, in either order; null where nothing.
const FitEdit* editOf(const FitSettings& settings, const std::string& a, const std::string& b);

/// What a person says of fits, as evidence is measured with it.
check::FitWords wordsOf(const FitSettings& settings);

}  // namespace glissade
