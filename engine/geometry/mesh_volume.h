#pragma once

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// Area of the mesh, square metres.
inline double areaOf(const TriangleMesh& mesh) {
  double twice = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    twice += (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
  }
  return 0.5 * twice;
}

/// Volume inside a closed surface, cubic metres; below 0 where it is inside out. Summed about a vertex, so that no
/// precision is lost far from the origin.
inline double signedVolume(const TriangleMesh& mesh) {
  if (mesh.vertices.empty()) return 0.0;
  const Vector3& about = mesh.vertices.front();
  double sixfold = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sixfold += (mesh.vertices[a] - about).dot((mesh.vertices[b] - about).cross(mesh.vertices[c] - about));
  }
  return sixfold / 6.0;
}

}  // namespace glissade
