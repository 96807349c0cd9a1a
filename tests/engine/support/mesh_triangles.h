#pragma once

#include <vector>

#include "engine/geometry/triangle_mesh.h"
#include "engine/geometry/triangle_pair.h"

namespace glissade {

inline std::vector<Triangle> trianglesOf(const TriangleMesh& mesh) {
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c] : mesh.triangles) {
    triangles.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
  }
  return triangles;
}

}  // namespace glissade
