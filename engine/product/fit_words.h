#pragma once

#include <string>

#include "engine/check/product.h"
#include "engine/product/fit_settings.h"

namespace glissade {

/// A person's statement about a pair, in either order; null if there is none.
const FitEdit* editOf(const FitSettings& settings, const std::string& a, const std::string& b);

/// A person's statements about fits, as the judge takes them.
check::FitWords wordsOf(const FitSettings& settings);

}  // namespace glissade
