#pragma once

#include "engine/geometry/pose.h"

namespace glissade {

/// Exact signs (-1, 0 or 1) of determinants for every input that neither over- nor underflows. An error bound decides
/// nearly all in floating point, expansions (Shewchuk 1997) the rest.

/// The side of the plane through a, b, c on which d lies; 0 exactly where the four points are coplanar.
int orientation3d(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d);

/// The turn from a by b to c in the projection without coordinate `dropped`; 0 exactly where the three projections lie
/// on a line.
int orientation2d(const Vector3& a, const Vector3& b, const Vector3& c, int dropped);

}  // namespace glissade
