#include "engine/import/step_face_boundary.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <ElSLib.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Cylinder.hxx>
#include <numbers>

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

/// Removes the edge that both have, and lets each begin behind it. False if they have none.
bool leaveOutShared(FaceBoundary& one, FaceBoundary& other) {
  for (auto own = one.begin(); own != one.end(); ++own) {
    const auto same =
        std::find_if(other.begin(), other.end(), [&](const BoundaryEdge& each) { return each.edge.IsSame(own->edge); });
    if (same == other.end() || same->edge.Orientation() == own->edge.Orientation()) continue;
    std::rotate(one.begin(), own, one.end());
    std::rotate(other.begin(), same, other.end());
    one.erase(one.begin());
    other.erase(other.begin());
    return true;
  }
  return false;
}

/// Gives the points parameters of the cylinder without jumps.
void unroll(FaceBoundary& boundary, const gp_Cylinder& cylinder) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  std::optional<double> before;
  for (BoundaryEdge& edge : boundary) {
    for (BoundaryPoint& point : edge.points) {
      double u = 0.0;
      double v = 0.0;
      ElSLib::Parameters(cylinder, point.point, u, v);
      if (before) u += kTurn * std::round((*before - u) / kTurn);
      point.at = {u, v};
      before = u;
    }
  }
}

}  // namespace

bool isClosedInParameters(const FaceBoundary& boundary, const TopoDS_Face& face) {
  const BRepAdaptor_Surface surface(face, false);
  if (!surface.IsUPeriodic()) return true;
  const double most = 0.5 * surface.UPeriod();
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    const BoundaryEdge& next = boundary[(i + 1) % boundary.size()];
    if (std::abs(boundary[i].points.back().at.X() - next.points.front().at.X()) > most) return false;
  }
  return true;
}

FaceBoundary reversed(FaceBoundary boundary) {
  std::reverse(boundary.begin(), boundary.end());
  for (BoundaryEdge& edge : boundary) {
    edge.edge.Reverse();
    std::reverse(edge.parameters.begin(), edge.parameters.end());
    std::reverse(edge.points.begin(), edge.points.end());
  }
  return boundary;
}

std::optional<FaceBoundary> joinedBoundary(FaceBoundary one, FaceBoundary other, const TopoDS_Face& face) {
  if (!leaveOutShared(one, other)) return std::nullopt;
  for (BoundaryEdge& edge : other) one.push_back(std::move(edge));
  unroll(one, BRepAdaptor_Surface(face, false).Cylinder());
  return isClosedInParameters(one, face) ? std::optional(std::move(one)) : std::nullopt;
}

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
