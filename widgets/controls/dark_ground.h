#pragma once

namespace glissade {

/// Whether white is more legible than black on a background with these shares of red, green and blue, by its relative
/// luminance (WCAG, simplified).
inline bool isDarkGround(double red, double green, double blue) {
  constexpr double kMiddle = 0.18;
  return 0.2126 * red * red + 0.7152 * green * green + 0.0722 * blue * blue < kMiddle;
}

}  // namespace glissade
