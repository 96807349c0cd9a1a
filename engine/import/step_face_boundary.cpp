#include "engine/import/step_face_boundary.h"

#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <optional>

namespace glissade {
namespace {

/// Adds an edge without length: one point of space, a line of parameters.
void addDegenerated(const TopoDS_Edge& edge, const Geom2d_Curve& curve, double first, double last,
                    BoundaryEdge& found) {
  constexpr int kParts = 16;
  const gp_Pnt point = BRep_Tool::Pnt(TopExp::FirstVertex(edge));
  for (int i = 0; i <= kParts; ++i) {
    const double parameter = first + (last - first) * i / kParts;
    found.parameters.push_back(parameter);
    found.points.push_back({curve.Value(parameter), point});
  }
}

std::optional<BoundaryEdge> boundaryEdge(const TopoDS_Edge& edge, const TopoDS_Face& face, EdgePolygons& polygons) {
  double first = 0.0;
  double last = 0.0;
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  if (curve.IsNull()) return std::nullopt;
  BoundaryEdge found{edge, {}, {}};
  if (BRep_Tool::Degenerated(edge)) {
    addDegenerated(edge, *curve, first, last, found);
  } else {
    const EdgePolygon& polygon = polygons.of(edge);
    if (polygon.points.size() < 2) return std::nullopt;
    found.parameters = polygon.parameters;
    for (std::size_t i = 0; i < polygon.points.size(); ++i) {
      found.points.push_back({curve->Value(polygon.parameters[i]), polygon.points[i]});
    }
  }
  if (edge.Orientation() == TopAbs_REVERSED) {
    std::reverse(found.parameters.begin(), found.parameters.end());
    std::reverse(found.points.begin(), found.points.end());
  }
  return found;
}

std::optional<FaceBoundary> boundaryOf(const TopoDS_Wire& wire, const TopoDS_Face& face, EdgePolygons& polygons) {
  std::size_t edges = 0;
  for (TopExp_Explorer at(wire, TopAbs_EDGE); at.More(); at.Next()) ++edges;
  FaceBoundary boundary;
  for (BRepTools_WireExplorer at(wire, face); at.More(); at.Next()) {
    auto edge = boundaryEdge(at.Current(), face, polygons);
    if (!edge) return std::nullopt;
    boundary.push_back(std::move(*edge));
  }
  return boundary.size() == edges && edges > 0 ? std::optional(std::move(boundary)) : std::nullopt;
}

}  // namespace

std::vector<FaceBoundary> boundariesOf(const TopoDS_Face& face, EdgePolygons& polygons) {
  std::vector<FaceBoundary> boundaries;
  for (TopExp_Explorer wire(face, TopAbs_WIRE); wire.More(); wire.Next()) {
    auto boundary = boundaryOf(TopoDS::Wire(wire.Current()), face, polygons);
    if (!boundary) return {};
    boundaries.push_back(std::move(*boundary));
  }
  return boundaries;
}

}  // namespace glissade
