#pragma once

#include <string>

#include "engine/evidence/pair_words.h"
#include "engine/fits/fit_settings.h"

namespace glissade {

/// A person's statement about a pair, in either order; null if there is none.
const FitEdit* editOf(const FitSettings& settings, const std::string& a, const std::string& b);

/// A person's statements about fits, as the judge takes them.
evidence::FitWords wordsOf(const FitSettings& settings);

}  // namespace glissade
