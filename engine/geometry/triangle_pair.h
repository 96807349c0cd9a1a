#pragma once

#include <array>

#include "engine/geometry/pose.h"

namespace glissade {

using Triangle = std::array<Vector3, 3>;

/// True if the closed triangles have a point in common. Exact for the given coordinates, including flat and degenerate
/// triangles.
bool trianglesMeet(const Triangle& a, const Triangle& b);

/// A nearest pair of points.
struct TriangleDistance {
  double squared = 0.0;
  Vector3 onA = Vector3::Zero();
  Vector3 onB = Vector3::Zero();
};

/// Distance of triangles that do not meet: the smallest over the pairs of edges, and of corners with faces. A
/// degenerate triangle counts as a segment or a point.
TriangleDistance triangleDistance(const Triangle& a, const Triangle& b);

/// Squared distance of the segment from p to q from a triangle, 0 to rounding where they meet. A degenerate triangle
/// counts as a segment or a point, and a degenerate segment as a point.
double squaredSegmentDistance(const Vector3& p, const Vector3& q, const Triangle& triangle);

}  // namespace glissade
