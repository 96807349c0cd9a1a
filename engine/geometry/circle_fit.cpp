#include "engine/geometry/circle_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace glissade {

std::optional<FittedCircle> fitCircle(const std::vector<Vector3>& points, const Vector3& axis) {
  if (points.empty()) return std::nullopt;
  const Vector3 u = axis.unitOrthogonal();
  const Vector3 v = axis.cross(u);
  const Vector3& origin = points.front();
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Vector3 right = Vector3::Zero();
  double scale = 0.0;
  for (const Vector3& p : points) scale = std::max(scale, (p - origin).norm());
  if (!(scale > 0.0)) return std::nullopt;
  for (const Vector3& p : points) {
    const Vector3 row((p - origin).dot(u) / scale, (p - origin).dot(v) / scale, 1.0);
    normal += row * row.transpose();
    right += row * row.head<2>().squaredNorm();
  }
  const Vector3 found = normal.ldlt().solve(right);
  const double squared = found.z() + 0.25 * found.head<2>().squaredNorm();
  if (!found.allFinite() || !(squared > 0.0)) return std::nullopt;
  return FittedCircle{origin + 0.5 * scale * (found.x() * u + found.y() * v), scale * std::sqrt(squared)};
}

}  // namespace glissade
