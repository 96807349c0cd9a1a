#include "engine/evidence/ray_containment.h"

#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace glissade::evidence {
namespace {

/// Limit of the rays for a point: each new one grazes an edge with probability near zero.
constexpr int kMostRays = 64;
/// A ray grazes a triangle if it is within this distance of the border, in barycentric coordinates.
constexpr double kGrazing = 1e-9;

/// For each vertex, the first vertex at the same position.
std::vector<std::uint32_t> sameVertices(const TriangleMesh& mesh) {
  std::map<std::tuple<double, double, double>, std::uint32_t> first;
  std::vector<std::uint32_t> same;
  for (const Vector3& v : mesh.vertices) {
    const auto next = static_cast<std::uint32_t>(same.size());
    same.push_back(first.try_emplace({v.x(), v.y(), v.z()}, next).first->second);
  }
  return same;
}

/// Follows the links of a forest to the root, shortening them on the way.
std::uint32_t rootOf(std::vector<std::uint32_t>& parent, std::uint32_t at) {
  while (parent[at] != at) at = parent[at] = parent[parent[at]];
  return at;
}

/// Directions that are spread evenly over the sphere.
Vector3 direction(int index) {
  const double z = 1.0 - (2.0 * index + 1.0) / kMostRays;
  const double around = 2.399963229728653 * index + 0.7312;
  const double radius = std::sqrt(1.0 - z * z);
  return {radius * std::cos(around), radius * std::sin(around), z};
}

}  // namespace

RaySolid::RaySolid(TriangleMesh mesh) : mesh_(std::move(mesh)) {
  for (const Vector3& vertex : mesh_.vertices) box_.extend(vertex);
  const std::vector<std::uint32_t> same = sameVertices(mesh_);
  std::vector<std::uint32_t> parent(same.size());
  std::iota(parent.begin(), parent.end(), 0U);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> edges;  // uses, and sum of their senses
  for (const TriangleIndices& corners : mesh_.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = same[corners[i]];
      const std::uint32_t b = same[corners[(i + 1) % 3]];
      if (a == b) continue;
      auto& [uses, sense] = edges[std::minmax(a, b)];
      ++uses;
      sense += a < b ? 1 : -1;
      parent[rootOf(parent, a)] = rootOf(parent, b);
    }
  }
  for (const auto& [ends, use] : edges) {
    closed_ = closed_ && use.first % 2 == 0;
    oriented_ = oriented_ && use.second == 0;
  }
  std::vector<bool> known(same.size(), false);
  for (const TriangleIndices& corners : mesh_.triangles) {
    const std::uint32_t root = rootOf(parent, same[corners[0]]);
    if (!known[root]) partPoints_.push_back(mesh_.vertices[corners[0]]);
    known[root] = true;
  }
}

bool RaySolid::contains(const Vector3& point) const {
  if (!closed_ || !box_.contains(point)) return false;
  for (int ray = 0; ray < kMostRays; ++ray) {
    if (const auto count = crossings(point, direction(ray))) return *count != 0;
  }
  return true;  // no ray without grazing: inside is the careful answer
}

std::optional<int> RaySolid::crossings(const Vector3& point, const Vector3& direction) const {
  int count = 0;
  for (const auto& [a, b, c] : mesh_.triangles) {
    const Vector3 u = mesh_.vertices[b] - mesh_.vertices[a];
    const Vector3 v = mesh_.vertices[c] - mesh_.vertices[a];
    const Vector3 normal = u.cross(v);
    const double area = normal.norm();
    const double slope = normal.dot(direction);
    if (area == 0.0) continue;
    const Vector3 w = point - mesh_.vertices[a];
    if (std::abs(slope) <= kGrazing * area) {
      if (std::abs(w.dot(normal)) <= kGrazing * area * box_.diagonal().norm()) return std::nullopt;  // in the plane
      continue;
    }
    const double second = u.cross(w).dot(direction) / slope;
    const double first = w.cross(v).dot(direction) / slope;
    const double third = 1.0 - first - second;
    const double inmost = std::min({first, second, third});
    if (inmost < -kGrazing || w.dot(normal) / slope > 0.0) continue;
    if (inmost < kGrazing) return std::nullopt;
    count += slope > 0.0 ? 1 : -1;
  }
  return oriented_ ? count : count % 2;
}

}  // namespace glissade::evidence
