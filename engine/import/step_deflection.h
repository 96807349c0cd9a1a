#pragma once

#include <algorithm>

namespace glissade {

/// The default deflection of a STEP part's triangles from its surface: a thousandth of the part's diagonal, from 0.01
/// to 0.5 mm. All in metres.
inline double usualDeflection(double diagonal) { return std::clamp(0.001 * diagonal, 1e-5, 5e-4); }

/// Largest angle between two neighbouring triangles of a curved face, radians, so that small rounds stay round.
inline constexpr double kStepAngle = 0.35;

}  // namespace glissade
