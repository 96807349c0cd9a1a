#pragma once

#include <span>
#include <string_view>

namespace glissade {

struct FrenchText {
  std::string_view english;
  std::string_view french;
};

/// The texts of `resources/i18n/glissade_fr.ts`, sorted by the English text. The source is made by the build.
std::span<const FrenchText> frenchTexts();

}  // namespace glissade
