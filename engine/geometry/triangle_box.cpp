#include "engine/geometry/triangle_box.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

/// Shrinks the cube so that a surface on its face, up to rounding, is outside.
constexpr double kInterior = 1.0 - 1e-9;

/// The projections of triangle and cube on `axis` do not overlap. An edge along a coordinate axis gives
/// a null vector, which separates nothing.
bool separates(const Vector3& axis, const std::array<Vector3, 3>& v, double half) {
  const double a = axis.dot(v[0]);
  const double b = axis.dot(v[1]);
  const double c = axis.dot(v[2]);
  const double reach = half * axis.lpNorm<1>();
  return reach > 0.0 && (std::min({a, b, c}) >= reach || std::max({a, b, c}) <= -reach);
}

}  // namespace

bool triangleEntersCube(const std::array<Vector3, 3>& triangle, const Vector3& centre, double half) {
  const double inner = half * kInterior;
  const std::array<Vector3, 3> v{triangle[0] - centre, triangle[1] - centre, triangle[2] - centre};
  for (int i = 0; i < 3; ++i) {
    if (std::min({v[0][i], v[1][i], v[2][i]}) >= inner || std::max({v[0][i], v[1][i], v[2][i]}) <= -inner) return false;
  }
  const std::array<Vector3, 3> edges{v[1] - v[0], v[2] - v[1], v[0] - v[2]};
  const Vector3 normal = edges[0].cross(edges[1]);
  const double offset = normal.dot(v[0]);
  if (std::abs(offset) >= inner * normal.lpNorm<1>()) return false;
  for (const Vector3& e : edges) {
    if (separates({0.0, -e.z(), e.y()}, v, inner) || separates({e.z(), 0.0, -e.x()}, v, inner) ||
        separates({-e.y(), e.x(), 0.0}, v, inner)) {
      return false;
    }
  }
  return true;
}

}  // namespace glissade
