#pragma once

#include <algorithm>

namespace glissade {

/// How far the triangles of a STEP part may be off its surface where nobody says: a thousandth of the
/// part's diagonal, from 0.01 to 0.5 mm. All in metres.
inline double usualDeflection(double diagonal) { return std::clamp(0.001 * diagonal, 1e-5, 5e-4); }

/// Radians that two neighbouring triangles of a curved face may be turned against each other, so that
/// small rounds stay round.
inline constexpr double kStepAngle = 0.35;

}  // namespace glissade
