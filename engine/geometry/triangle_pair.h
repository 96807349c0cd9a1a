#pragma once

#include <array>

#include "engine/geometry/pose.h"

namespace glissade {

using Triangle = std::array<Vector3, 3>;

/// The closed triangles have a point in common: exact for the coordinates given, flat and degenerate
/// triangles included.
bool trianglesMeet(const Triangle& a, const Triangle& b);

/// A nearest pair of points.
struct TriangleDistance {
  double squared = 0.0;
  Vector3 onA = Vector3::Zero();
  Vector3 onB = Vector3::Zero();
};

/// Distance of triangles that do not meet: the smallest over the pairs of edges, and of corners with
/// faces. Degenerate triangles are taken as the segment or point that they are.
TriangleDistance triangleDistance(const Triangle& a, const Triangle& b);

/// Squared distance of the segment from p to q from a triangle, 0 to rounding where they meet. A degenerate triangle is
/// the segment or point that it is, and so is the segment.
double squaredSegmentDistance(const Vector3& p, const Vector3& q, const Triangle& triangle);

}  // namespace glissade
