#pragma once

namespace glissade {

// Units of length that are no power of ten of a metre, in metres.
inline constexpr double kInch = 0.0254;
inline constexpr double kFoot = 0.3048;

}  // namespace glissade
