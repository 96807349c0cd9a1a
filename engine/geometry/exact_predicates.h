#pragma once

#include "engine/geometry/pose.h"

namespace glissade {

/// Signs of determinants that are right for every input that neither over- nor underflows: an error
/// bound settles nearly all in floating point, expansions (Shewchuk 1997) the rest. -1, 0 or 1.

/// The side of the plane through a, b, c on which d lies: 0 exactly where the four are coplanar.
int orientation3d(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d);

/// The turn from a by b to c after the coordinate `dropped` is left out: 0 exactly where the three
/// projections lie on a line.
int orientation2d(const Vector3& a, const Vector3& b, const Vector3& c, int dropped);

}  // namespace glissade
