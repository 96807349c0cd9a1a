#pragma once

namespace glissade {

/// Movements of a hand from rest to rest (Flash and Hogan 1985).
namespace minimum_jerk {

inline constexpr double kPeakOverMean = 1.875;  ///< of the speed
inline constexpr double kShortest = 0.3;        ///< s

/// Share of the movement that is done after the share s of its time.
constexpr double share(double s) { return s * s * s * (10.0 + s * (-15.0 + s * 6.0)); }

}  // namespace minimum_jerk

}  // namespace glissade
