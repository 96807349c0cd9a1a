#pragma once

namespace glissade {

/// Movements of a hand from rest to rest (Flash and Hogan 1985).
namespace minimum_jerk {

inline constexpr double kPeakOverMean = 1.875;  ///< peak speed divided by mean speed
inline constexpr double kShortest = 0.3;        ///< shortest movement, seconds

/// Share of the movement at the share s of its time.
constexpr double share(double s) { return s * s * s * (10.0 + s * (-15.0 + s * 6.0)); }

}  // namespace minimum_jerk

}  // namespace glissade
