#include "engine/geometry/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/reserve_filled.h"
#include "engine/geometry/vertex_welder.h"

namespace glissade {
namespace {

SurfaceFace scaled(SurfaceFace face, const Vector3& factors) {
  const double largest = factors.cwiseAbs().maxCoeff();
  const bool even = factors.x() == factors.y() && factors.y() == factors.z() && factors.x() > 0.0;
  face.deflection *= largest;
  if (!even) return {.deflection = face.deflection};
  face.point *= largest;
  face.radius *= largest;
  if (face.kind == SurfaceFace::Kind::Torus) face.second *= largest;
  return face;
}

/// Adds a Free face to a mesh without faces, so that each triangle has one.
void giveFace(TriangleMesh& mesh) {
  if (!mesh.faceOf.empty() || mesh.triangles.empty()) return;
  mesh.faces.assign(1, SurfaceFace());
  mesh.faceOf.assign(mesh.triangles.size(), 0);
}

}  // namespace

SurfaceFace transformed(const SurfaceFace& face, const Pose& X_AB) {
  SurfaceFace moved = face;
  moved.point = X_AB * face.point;
  moved.axis = X_AB.orientation * face.axis;
  return moved;
}

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
  for (SurfaceFace& face : result.faces) face = transformed(face, X_AB);
  return result;
}

TriangleMesh scaled(const TriangleMesh& mesh, const Vector3& factors) {
  TriangleMesh result = mesh;
  for (Vector3& vertex : result.vertices) vertex = vertex.cwiseProduct(factors);
  for (SurfaceFace& face : result.faces) face = scaled(face, factors);
  const bool mirrored = factors.prod() < 0.0;
  if (mirrored) {
    for (auto& triangle : result.triangles) std::swap(triangle[1], triangle[2]);
  }
  return result;
}

void append(TriangleMesh& target, const TriangleMesh& addition) {
  const auto offset = static_cast<std::uint32_t>(target.vertices.size());
  target.vertices.insert(target.vertices.end(), addition.vertices.begin(), addition.vertices.end());
  if (!target.faces.empty() || !addition.faces.empty()) {
    giveFace(target);
    const auto firstFace = static_cast<std::uint32_t>(target.faces.size());
    TriangleMesh faced{{}, addition.triangles, addition.faces, addition.faceOf};
    giveFace(faced);
    target.faces.insert(target.faces.end(), faced.faces.begin(), faced.faces.end());
    for (const std::uint32_t face : faced.faceOf) target.faceOf.push_back(firstFace + face);
  }
  for (const auto& [a, b, c] : addition.triangles) {
    target.triangles.push_back({a + offset, b + offset, c + offset});
  }
}

TriangleMesh welded(const TriangleMesh& mesh) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  // Each vertex is looked up once, for any number of triangles.
  VertexWelder welder(mesh.vertices.size());
  std::vector<std::uint32_t> positionOf;
  reserveFilled(positionOf, mesh.vertices.size());
  for (const Vector3& vertex : mesh.vertices) positionOf.push_back(welder.indexOf(vertex));
  std::vector<std::uint32_t> numberOf(welder.vertices().size(), kNone);
  TriangleMesh result;
  reserveFilled(result.vertices, welder.vertices().size());
  reserveFilled(result.triangles, mesh.triangles.size());
  result.faces = mesh.faces;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const TriangleIndices& triangle = mesh.triangles[t];
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
    if (degenerate) continue;
    result.triangles.push_back(joined);
    if (!mesh.faceOf.empty()) result.faceOf.push_back(mesh.faceOf[t]);
  }
  return result;
}

}  // namespace glissade
