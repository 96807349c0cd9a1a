#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/triangle_mesh.h"
#include "engine/geometry/triangle_pair.h"

namespace glissade {

/// Triangles in a hierarchy of boxes, for many rays. Immutable, shared by threads.
class RayTree {
 public:
  explicit RayTree(std::vector<Triangle> triangles);

  /// The least t > `after` at which origin + t * direction lies on a triangle, borders included as far as
  /// rounding allows; infinity where there is none.
  double firstHit(const Vector3& origin, const Vector3& direction, double after) const;

 private:
  /// Around some triangles: those of a leaf, or of the two nodes below.
  struct Node {
    Box3 box;
    std::uint32_t first = 0;  ///< triangle of a leaf, else the node below that is not the next one
    std::uint32_t count = 0;  ///< of a leaf's triangles; 0: no leaf
  };

  void build(std::uint32_t first, std::uint32_t last);

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

}  // namespace glissade
