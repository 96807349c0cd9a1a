#pragma once

#include <array>

#include "engine/geometry/pose.h"

namespace glissade {

/// A triangle prepared for tests against many axis-aligned cubes: the axes that may separate it from a cube
/// (Akenine-Moller 2001), and its extent along each.
class CubeIntersector {
 public:
  explicit CubeIntersector(const std::array<Vector3, 3>& triangle);

  /// True if the triangle meets the interior of the cube about `centre` with half edge `half`. Touching does not count,
  /// and a triangle without area enters nothing.
  bool enters(const Vector3& centre, double half) const;

 private:
  struct Axis {
    Vector3 direction;
    double low;  ///< least extent of the triangle along `direction`, from its first vertex
    double high;
    double reach;  ///< half extent of a cube with half edge 1
  };

  void add(const Vector3& direction, const Vector3& ab, const Vector3& ac);

  Vector3 first_;
  Eigen::Array3d low_;  ///< lower corner of the bounding box, from the first vertex
  Eigen::Array3d high_;
  std::array<Axis, 10> axes_;  ///< the normal, and the edges' cross products with the coordinate axes
  int count_ = 0;
};

}  // namespace glissade
