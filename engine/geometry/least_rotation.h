#pragma once

#include "engine/geometry/pose.h"

namespace glissade {

/// The least rotation that takes the direction `from` to the direction `to`; neither is zero. Only one source uses
/// Eigen's FromTwoVectors(), because its template takes the compiler six seconds.
Quaternion leastRotation(const Vector3& from, const Vector3& to);

}  // namespace glissade
