#pragma once

#include <TopoDS_Face.hxx>

#include "engine/import/step_edge_polygons.h"

namespace glissade {

/// How a face got its triangles.
enum class FaceMeshing : std::uint8_t {
  Failed,
  InParameters,   ///< between its boundaries in the parameters of its surface; points on the surface where needed
  BetweenPoints,  ///< between the points of its boundaries alone: some of its triangles overlap
};

/// Gives a face triangles between the polygons of its edges, about `deflection` (millimetres) or less off its surface
/// where its boundaries permit it. No point of an edge is new or moves. What the face and its edges had of triangles
/// is removed if this succeeds, and stays otherwise. Runs in the importing process only.
FaceMeshing meshFace(const TopoDS_Face& face, double deflection, EdgePolygons& polygons);

}  // namespace glissade
