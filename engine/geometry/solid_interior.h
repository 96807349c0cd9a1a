#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/geometry/triangle_mesh.h"
#include "engine/geometry/triangle_pair.h"

namespace glissade {

/// The interior of the solid that a closed mesh bounds, for many points: a ray along +x meets only the few triangles of
/// one column. Exact for a point that does not lie on the surface: a ray through edges and corners is treated as one
/// that is shifted infinitesimally. Immutable, shared by threads.
class SolidInterior {
 public:
  /// Precondition: the mesh is closed. Where its triangles have a consistent orientation, parts may overlap, as with
  /// the winding number; else points alternate between outside and inside along the ray.
  explicit SolidInterior(const TriangleMesh& closedMesh, bool consistentlyOriented);

  bool contains(const Vector3& p) const;

 private:
  std::size_t columnAlong(int axis, double coordinate) const;
  std::size_t entriesAt(std::size_t resolution);
  void fillColumns();

  std::vector<Triangle> triangles_;
  std::vector<Box3> boxes_;  ///< bounding box of each triangle
  bool oriented_;
  Box3 box_;
  std::size_t resolution_ = 1;  ///< number of columns along y and along z
  std::vector<std::uint32_t> begins_;
  std::vector<std::uint32_t> entries_;
};

}  // namespace glissade
