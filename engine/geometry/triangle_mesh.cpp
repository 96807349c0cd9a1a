#include "engine/geometry/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <unordered_map>

namespace glissade {
namespace {

struct PlaceHash {
  std::size_t operator()(const Vector3& p) const {
    constexpr std::size_t kOdd = 0x9e3779b97f4a7c15U;
    const std::hash<double> hash;
    return (hash(p.x()) * kOdd + hash(p.y())) * kOdd + hash(p.z());
  }
};

}  // namespace

Box3 boundingBox(const TriangleMesh& mesh) { return boundingBox(mesh, Pose::identity()); }

Box3 boundingBox(const TriangleMesh& mesh, const Pose& X_WB) {
  Box3 box;
  for (const Vector3& vertex : mesh.vertices) box.extend(X_WB * vertex);
  return box;
}

double radiusAboutOrigin(const TriangleMesh& mesh) {
  double squared = 0.0;
  for (const Vector3& vertex : mesh.vertices) squared = std::max(squared, vertex.squaredNorm());
  return std::sqrt(squared);
}

Vector3 faceNormal(const TriangleMesh& mesh, const TriangleIndices& triangle) {
  const Vector3& corner = mesh.vertices[triangle[0]];
  const Vector3 normal = (mesh.vertices[triangle[1]] - corner).cross(mesh.vertices[triangle[2]] - corner);
  return normal.isZero(0.0) ? Vector3::UnitZ() : Vector3(normal.stableNormalized());
}

TriangleMesh transformed(const TriangleMesh& mesh, const Pose& X_AB) {
  TriangleMesh result = mesh;
  for (Vector3& vertex : result.vertices) vertex = X_AB * vertex;
  return result;
}

TriangleMesh scaled(const TriangleMesh& mesh, const Vector3& factors) {
  TriangleMesh result = mesh;
  for (Vector3& vertex : result.vertices) vertex = vertex.cwiseProduct(factors);
  const bool mirrored = factors.prod() < 0.0;
  if (mirrored) {
    for (auto& triangle : result.triangles) std::swap(triangle[1], triangle[2]);
  }
  return result;
}

void append(TriangleMesh& target, const TriangleMesh& addition) {
  const auto offset = static_cast<std::uint32_t>(target.vertices.size());
  target.vertices.insert(target.vertices.end(), addition.vertices.begin(), addition.vertices.end());
  for (const auto& [a, b, c] : addition.triangles) {
    target.triangles.push_back({a + offset, b + offset, c + offset});
  }
}

TriangleMesh welded(const TriangleMesh& mesh) {
  TriangleMesh result;
  std::unordered_map<Vector3, std::uint32_t, PlaceHash, std::equal_to<>> indexOf(mesh.vertices.size());
  const auto weld = [&](std::uint32_t vertex) {
    const Vector3& place = mesh.vertices[vertex];
    const auto [entry, inserted] = indexOf.try_emplace(place, static_cast<std::uint32_t>(result.vertices.size()));
    if (inserted) result.vertices.push_back(place);
    return entry->second;
  };
  for (const auto& triangle : mesh.triangles) {
    const TriangleIndices merged{weld(triangle[0]), weld(triangle[1]), weld(triangle[2])};
    const bool degenerate = merged[0] == merged[1] || merged[1] == merged[2] || merged[2] == merged[0];
    if (!degenerate) result.triangles.push_back(merged);
  }
  return result;
}

}  // namespace glissade
