#pragma once

#include <optional>
#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade::check {

/// The judge's notion of a solid: what a closed surface encloses, found by counting
/// the triangles that a ray from the point crosses.
class RaySolid {
 public:
  explicit RaySolid(TriangleMesh mesh);

  /// One vertex of each connected part of the surface.
  const std::vector<Vector3>& partPoints() const { return partPoints_; }
  /// Never true of an open surface. Not meaningful on the surface itself.
  bool contains(const Vector3& point) const;

 private:
  /// Crossings towards the outside less those towards the inside, or their parity where the triangles
  /// are not turned alike; nothing where the ray grazes an edge.
  std::optional<int> crossings(const Vector3& point, const Vector3& direction) const;

  TriangleMesh mesh_;
  Box3 box_;
  bool closed_ = true;
  bool oriented_ = true;
  std::vector<Vector3> partPoints_;
};

}  // namespace glissade::check
