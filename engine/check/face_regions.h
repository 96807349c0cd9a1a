#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade::check {

/// The faces of a surface as the judge takes them: the faces that the CAD file states, else flat pieces. Triangles that
/// hang together over edges bent by less than a tenth of a degree are one piece. What is in a fit at one face says
/// nothing about the faces that are bent against it: a prism under a lip may touch its hole at one side.
struct FaceRegions {
  std::vector<std::uint32_t> of;  ///< number of the region, of each triangle
  std::uint32_t count = 0;
  /// Regions next to each, bent against it by less than 36 degrees: together they are a smooth surface.
  std::vector<std::vector<std::uint32_t>> next;
  std::vector<bool> curved;  ///< the triangle is a facet: it is bent against a neighbour by less than 36 degrees
  /// Of each region: metres that the chords of the circles through its facets' edges are off them. A person may say
  /// that it is of a cylinder; nothing else makes use of it.
  std::vector<double> sagitta;
};

FaceRegions faceRegionsOf(const TriangleMesh& mesh);

}  // namespace glissade::check
