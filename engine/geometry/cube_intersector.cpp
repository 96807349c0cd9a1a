#include "engine/geometry/cube_intersector.h"

#include <algorithm>

namespace glissade {
namespace {

/// Factor that shrinks the cube, so that a surface on its face, up to rounding, is outside.
constexpr double kInterior = 1.0 - 1e-9;

}  // namespace

CubeIntersector::CubeIntersector(const std::array<Vector3, 3>& triangle) : first_(triangle[0]) {
  const Vector3 ab = triangle[1] - triangle[0];
  const Vector3 ac = triangle[2] - triangle[0];
  low_ = ab.cwiseMin(ac).cwiseMin(0.0);
  high_ = ab.cwiseMax(ac).cwiseMax(0.0);
  add(ab.cross(ac), ab, ac);
  for (const Vector3& edge : {ab, Vector3(ac - ab), ac}) {
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3 direction = edge.cross(Vector3::Unit(axis));
      // The bounding box covers the coordinate axes; a null vector separates nothing.
      if ((direction.array() != 0.0).count() == 2) add(direction, ab, ac);
    }
  }
}

void CubeIntersector::add(const Vector3& direction, const Vector3& ab, const Vector3& ac) {
  const double b = direction.dot(ab);
  const double c = direction.dot(ac);
  axes_[static_cast<std::size_t>(count_++)] = {direction, std::min({0.0, b, c}), std::max({0.0, b, c}),
                                               direction.lpNorm<1>()};
}

bool CubeIntersector::enters(const Vector3& centre, double half) const {
  const double inner = half * kInterior;
  const Vector3 offset = centre - first_;
  if ((low_ - inner >= offset.array()).any() || (high_ + inner <= offset.array()).any()) return false;
  for (int i = 0; i < count_; ++i) {
    const Axis& axis = axes_[static_cast<std::size_t>(i)];
    const double along = axis.direction.dot(offset);
    const double reach = inner * axis.reach;
    if (axis.low - along >= reach || axis.high - along <= -reach) return false;
  }
  return true;
}

}  // namespace glissade
