#pragma once

#include <TopoDS_Face.hxx>

#include "engine/import/step_edge_polygons.h"

namespace glissade {

/// The way in which a face got its triangles.
enum class FaceMeshing : std::uint8_t {
  Failed,
  InParameters,   ///< between its boundaries in the parameters of its surface; with points on the surface if needed
  BetweenPoints,  ///< between the points of its boundaries only: some triangles overlap
  WithOther,      ///< its boundary encloses nothing alone; the triangles of another face cover both
};

/// Triangulates a face between the polygons of its edges, within about `deflection` (millimetres) of its surface if the
/// boundaries permit it. Points of edges are neither added nor moved. Replaces the former triangles of the face and its
/// edges on success, and keeps them otherwise. Runs in the importing process only.
FaceMeshing meshFace(const TopoDS_Face& face, double deflection, EdgePolygons& polygons);

/// Triangulates two faces of one cylinder whose boundaries enclose nothing alone: the first one gets the triangles of
/// both, and the other one loses its own. False if they enclose nothing together. The triangulated faces of the
/// cylinder in `beside` tell the orientation of both.
bool meshTogether(const TopoDS_Face& face, const TopoDS_Face& other, const TopoDS_Shape& beside, double deflection,
                  EdgePolygons& polygons);

}  // namespace glissade
