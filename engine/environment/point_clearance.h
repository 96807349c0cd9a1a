#pragma once

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// The point of a triangle nearest to p (Ericson 2005, section 5.1.5).
Vector3 nearestOnTriangle(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c);

/// Distances from points to the surface of a mesh, for few points near each other.
class PointClearance {
 public:
  /// Keeps the triangles that come within `reach` of `about`.
  PointClearance(const TriangleMesh& mesh_W, const Vector3& about, double reach);

  /// Distance to the triangles kept, at most `reach`.
  double operator()(const Vector3& p_W) const;
  /// Goes uphill from p in ever smaller steps, at most `reach` / 2 away and not out of `within`;
  /// returns the widest spot found.
  Vector3 widestNear(const Vector3& p_W, double step, const Box3& within) const;

 private:
  std::vector<std::array<Vector3, 3>> triangles_;
  Vector3 about_;
  double reach_;
};

}  // namespace glissade
