#pragma once

#include "engine/geometry/pose.h"

namespace glissade {

/// The least rotation that takes the direction `from` to the direction `to`; neither is zero. The template behind
/// Eigen's FromTwoVectors() takes the compiler six seconds in each source that uses it, so one source does.
Quaternion leastRotation(const Vector3& from, const Vector3& to);

}  // namespace glissade
