#include "engine/geometry/least_rotation.h"

namespace glissade {

Quaternion leastRotation(const Vector3& from, const Vector3& to) { return Quaternion::FromTwoVectors(from, to); }

}  // namespace glissade
