#pragma once

#include <optional>
#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade::evidence {

/// The solid that a closed surface encloses, by counting the triangles that a ray from the point crosses. Used by the
/// judge only.
class RaySolid {
 public:
  explicit RaySolid(TriangleMesh mesh);

  /// One vertex of each connected part of the surface.
  const std::vector<Vector3>& partPoints() const { return partPoints_; }
  /// False for an open surface. Without meaning on the surface itself.
  bool contains(const Vector3& point) const;

 private:
  /// Outward crossings minus inward crossings, or their parity if the triangles are not oriented alike; nothing if the
  /// ray grazes an edge.
  std::optional<int> crossings(const Vector3& point, const Vector3& direction) const;

  TriangleMesh mesh_;
  Box3 box_;
  bool closed_ = true;
  bool oriented_ = true;
  std::vector<Vector3> partPoints_;
};

}  // namespace glissade::evidence
