#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <optional>
#include <vector>

#include "engine/import/step_edge_polygons.h"

namespace glissade {

/// A corner of a boundary, in the parameters of the surface and in space.
struct BoundaryPoint {
  gp_Pnt2d at;
  gp_Pnt point;  ///< in the frame of the shape
};

/// An edge in a boundary of a face.
struct BoundaryEdge {
  TopoDS_Edge edge;  ///< with the orientation of the boundary
  std::vector<double> parameters;
  std::vector<BoundaryPoint> points;  ///< along the boundary; the last point is the first of the next edge
};

using FaceBoundary = std::vector<BoundaryEdge>;

/// The boundaries of a face that is not reversed. Empty if one of them is not closed. Runs in the importing process
/// only.
std::vector<FaceBoundary> boundariesOf(const TopoDS_Face& face, EdgePolygons& polygons);

/// True if the boundary ends in the parameters where it begins. A boundary that goes around a cylinder once does not,
/// and encloses nothing alone.
bool isClosedInParameters(const FaceBoundary& boundary, const TopoDS_Face& face);

/// The boundary in the other sense.
FaceBoundary reversed(FaceBoundary boundary);

/// Two boundaries on one cylinder together, without the edge that they share, in its parameters: two that go around it
/// enclose a band. Nothing if they share no edge, or if they enclose nothing.
std::optional<FaceBoundary> joinedBoundary(FaceBoundary one, FaceBoundary other, const TopoDS_Face& face);

}  // namespace glissade
