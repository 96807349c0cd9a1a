#pragma once

#include <vector>

#include "engine/geometry/triangle_tree.h"

namespace glissade {

/// A point where two bodies touch.
struct ContactPoint {
  Vector3 point;
  Vector3 normal;  ///< unit, out of the first body
};

/// Points at which forces act between two bodies that touch: points of the surface of `a` within `distance` of the
/// surface of `b`, outside or inside of it, reduced to the outermost ones for each direction of the normal. Both meshes
/// are in the world frame; `a` has outward normals where it is closed.
std::vector<ContactPoint> contactPoints(const TriangleTree& a, const TriangleTree& b, double distance);

}  // namespace glissade
