#pragma once

#include <array>
#include <vector>

#include "engine/geometry/pose.h"

namespace glissade {

/// A ball that the body never enters.
struct FreeBall {
  Vector3 middle;
  double radius;
};

/// A tetrahedron with values at its corners, linear in between.
struct ValuedTetrahedron {
  std::array<Vector3, 4> corners;
  std::array<double, 4> values;
};

/// The least level, not below 0, above which all of the tetrahedron lies in one of the balls. The largest of the values
/// where there is no such level below that.
double certifiedLevel(const ValuedTetrahedron& tetrahedron, const std::vector<FreeBall>& balls);

}  // namespace glissade
