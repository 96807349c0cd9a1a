#pragma once

#include <vector>

#include "engine/geometry/triangle_tree.h"

namespace glissade {

/// A point where two bodies touch.
struct ContactPoint {
  Vector3 point;
  Vector3 normal;  ///< unit, out of the first body
};

/// Where two bodies touch, for forces between them: points of the surface of `a` that are no farther than `distance`
/// from `b`, or inside of it by no more than that, reduced to the outermost ones of each direction of the normal. Both
/// in the world frame; `a` has outward normals where it is closed.
std::vector<ContactPoint> contactPoints(const TriangleTree& a, const TriangleTree& b, double distance);

}  // namespace glissade
