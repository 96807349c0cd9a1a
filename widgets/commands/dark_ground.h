#pragma once

namespace glissade {

/// Whether white stands out better than black on a ground with these shares of red, green and blue: its relative
/// luminance as WCAG has it, simplified.
inline bool isDarkGround(double red, double green, double blue) {
  constexpr double kMiddle = 0.18;
  return 0.2126 * red * red + 0.7152 * green * green + 0.0722 * blue * blue < kMiddle;
}

}  // namespace glissade
