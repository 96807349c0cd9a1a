#include "engine/check/sweep.h"

#include <algorithm>
#include <set>
#include <utility>

namespace glissade::check {

TriangleMesh sweptBy(const TriangleMesh& mesh, const Vector3& way) {
  TriangleMesh swept = mesh;
  const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Vector3& vertex : mesh.vertices) swept.vertices.emplace_back(vertex + way);
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& [a, b, c] : mesh.triangles) {
    swept.triangles.push_back({a + count, b + count, c + count});
    edges.insert({std::minmax(a, b), std::minmax(b, c), std::minmax(c, a)});
  }
  for (const auto& [a, b] : edges) {
    swept.triangles.push_back({a, b, b + count});
    swept.triangles.push_back({a, b + count, a + count});
  }
  return swept;
}

bool passesOver(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& way, const Vector3& point) {
  Eigen::Matrix3d sides;
  sides << b - a, c - a, way;
  if (sides.determinant() == 0.0) return false;
  const Vector3 shares = sides.inverse() * (point - a);
  return shares.minCoeff() >= 0.0 && shares.x() + shares.y() <= 1.0 && shares.z() <= 1.0;
}

}  // namespace glissade::check
