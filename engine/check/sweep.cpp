#include "engine/check/sweep.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace glissade::check {
namespace {

/// Relative distance within which a corner is in the plane that an edge sweeps.
constexpr double kInPlane = 1e-9;

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Sine of the angle between an edge and the motion below which the edge sweeps no area; neighbouring edges sweep the
/// same points.
constexpr double kAlongTheWay = 1e-12;

bool isAlong(const TriangleMesh& mesh, const Edge& edge, const Vector3& way) {
  const Vector3 along = mesh.vertices[edge.second] - mesh.vertices[edge.first];
  return along.cross(way).norm() <= kAlongTheWay * along.norm() * way.norm();
}

/// Side of the plane swept by the edge on which the corner is: 1, -1, or 0 in the plane.
int sideOf(const TriangleMesh& mesh, const Edge& edge, std::uint32_t corner, const Vector3& way) {
  const Vector3 along = mesh.vertices[edge.second] - mesh.vertices[edge.first];
  const Vector3 out = mesh.vertices[corner] - mesh.vertices[edge.first];
  const double volume = along.cross(way).dot(out);
  if (std::abs(volume) <= kInPlane * along.norm() * way.norm() * out.norm()) return 0;
  return volume > 0.0 ? 1 : -1;
}

/// True if the two triangles are on either side of the plane that their edge sweeps, so that their prisms enclose it.
bool isInside(const TriangleMesh& mesh, const Edge& edge, const std::vector<std::uint32_t>& corners,
              const Vector3& way) {
  return corners.size() == 2 && sideOf(mesh, edge, corners[0], way) * sideOf(mesh, edge, corners[1], way) < 0;
}

}  // namespace

TriangleMesh sweptBy(const TriangleMesh& mesh, const Vector3& way) {
  TriangleMesh swept = mesh;
  const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Vector3& vertex : mesh.vertices) swept.vertices.emplace_back(vertex + way);
  std::map<Edge, std::vector<std::uint32_t>> edges;  // the opposite corners of each edge
  for (const TriangleIndices& triangle : mesh.triangles) {
    const auto& [a, b, c] = triangle;
    swept.triangles.push_back({a + count, b + count, c + count});
    for (std::size_t i = 0; i < 3; ++i) {
      edges[std::minmax(triangle[i], triangle[(i + 1) % 3])].push_back(triangle[(i + 2) % 3]);
    }
  }
  for (const auto& [edge, corners] : edges) {
    if (isAlong(mesh, edge, way) || isInside(mesh, edge, corners, way)) continue;
    const auto& [a, b] = edge;
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
