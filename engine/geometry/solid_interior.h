#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/geometry/triangle_mesh.h"
#include "engine/geometry/triangle_pair.h"

namespace glissade {

/// The inside of the solid that a closed mesh bounds, for many points: a ray along +x meets the few
/// triangles of one column. Exact, for a point that does not lie on the surface: a ray through edges
/// and corners is read as one moved aside by nearly nothing. Immutable, shared by threads.
class SolidInterior {
 public:
  /// The mesh must be closed. Where its triangles agree on an outside, parts may overlap, as with the
  /// winding number; where they do not, points alternate between outside and inside along the ray.
  explicit SolidInterior(const TriangleMesh& closedMesh, bool consistentlyOriented);

  bool contains(const Vector3& p) const;

 private:
  std::size_t columnAlong(int axis, double coordinate) const;
  std::size_t entriesAt(std::size_t resolution);
  void fillColumns();

  std::vector<Triangle> triangles_;
  std::vector<Box3> boxes_;  ///< around each
  bool oriented_;
  Box3 box_;
  std::size_t resolution_ = 1;  ///< columns along y and along z
  std::vector<std::uint32_t> begins_;
  std::vector<std::uint32_t> entries_;
};

}  // namespace glissade
