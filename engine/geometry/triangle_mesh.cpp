#include "engine/geometry/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/reserve_filled.h"
#include "engine/geometry/vertex_welder.h"

namespace glissade {

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
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  // Each vertex is looked up once, however many triangles have it.
  VertexWelder welder(mesh.vertices.size());
  std::vector<std::uint32_t> positionOf;
  reserveFilled(positionOf, mesh.vertices.size());
  for (const Vector3& vertex : mesh.vertices) positionOf.push_back(welder.indexOf(vertex));
  std::vector<std::uint32_t> numberOf(welder.vertices().size(), kNone);
  TriangleMesh result;
  reserveFilled(result.vertices, welder.vertices().size());
  reserveFilled(result.triangles, mesh.triangles.size());
  for (const TriangleIndices& triangle : mesh.triangles) {
    TriangleIndices joined;
    for (std::size_t i = 0; i < 3; ++i) {
      std::uint32_t& number = numberOf[positionOf[triangle[i]]];
      if (number == kNone) {
        number = static_cast<std::uint32_t>(result.vertices.size());
        result.vertices.push_back(mesh.vertices[triangle[i]]);
      }
      joined[i] = number;
    }
    const bool degenerate = joined[0] == joined[1] || joined[1] == joined[2] || joined[2] == joined[0];
    if (!degenerate) result.triangles.push_back(joined);
  }
  return result;
}

}  // namespace glissade
