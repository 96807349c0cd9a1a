#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade::evidence {

/// The faces of a surface, as the judge divides it: the faces that the CAD file states, else flat pieces. Triangles
/// that are connected over edges bent by less than a tenth of a degree are one piece. A fit at one face does not extend
/// to faces that are bent against it: a prism under a lip may touch its hole on one side only.
struct FaceRegions {
  std::vector<std::uint32_t> of;  ///< region of each triangle
  std::uint32_t count = 0;
  /// For each region, the neighbours that are bent against it by less than 36 degrees: together they are a smooth
  /// surface.
  std::vector<std::vector<std::uint32_t>> next;
  std::vector<bool> curved;  ///< for each triangle: it is bent against a neighbour by less than 36 degrees
  /// For each region, the deviation of chords from the circles through its facets' edges, metres. Used only if a person
  /// says that the region is cylindrical.
  std::vector<double> sagitta;
};

FaceRegions faceRegionsOf(const TriangleMesh& mesh);

}  // namespace glissade::evidence
