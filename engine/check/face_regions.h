#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade::check {

/// The faces of a surface as the judge takes them: triangles that hang together over edges with a dihedral angle below
/// 36 degrees are one region.
struct FaceRegions {
  std::vector<std::uint32_t> of;  ///< number of the region, of each triangle
  std::uint32_t count = 0;
  std::vector<bool> curved;  ///< the triangle is bent against a neighbour in its region
  /// Of each region: metres that the chords of the circles through its bent edges are off them. A person may say that a
  /// region is a cylinder; nothing else makes use of it.
  std::vector<double> sagitta;
};

FaceRegions faceRegionsOf(const TriangleMesh& mesh);

}  // namespace glissade::check
