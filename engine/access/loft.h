#pragma once

#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// A cross-section of a limb: an ellipse about a point.
struct LoftRing {
  Vector3 middle;
  Vector3 a;  ///< from the middle to the end of one half axis
  Vector3 b;  ///< to the end of the other half axis; a x b points along the rings
};

/// The closed surface through all rings, flat at both ends. Precondition: two rings or more.
TriangleMesh loft(const std::vector<LoftRing>& rings);

/// A limb with round ends between two points: the hull of two balls.
TriangleMesh taperedLimb(const Vector3& from, double fromRadius, const Vector3& to, double toRadius);

}  // namespace glissade
