#pragma once

#include <TopoDS_Face.hxx>

#include "engine/import/step_edge_polygons.h"

namespace glissade {

/// The way in which a face got its triangles.
enum class FaceMeshing : std::uint8_t {
  Failed,
  InParameters,   ///< between its boundaries in the parameters of its surface; with points on the surface if needed
  BetweenPoints,  ///< between the points of its boundaries only: some triangles overlap
};

/// Triangulates a face between the polygons of its edges, within about `deflection` (millimetres) of its surface if the
/// boundaries permit it. Points of edges are neither added nor moved. Replaces the former triangles of the face and its
/// edges on success, and keeps them otherwise. Runs in the importing process only.
FaceMeshing meshFace(const TopoDS_Face& face, double deflection, EdgePolygons& polygons);

}  // namespace glissade
