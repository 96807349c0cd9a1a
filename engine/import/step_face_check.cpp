#include "engine/import/step_face_check.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Pnt2d.hxx>
#include <optional>
#include <utility>
#include <vector>

namespace glissade {
namespace {

using Side = std::pair<int, int>;  ///< nodes, the smaller number first
Side sideOf(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// The sides with an odd number of occurrences, in order.
std::vector<Side> oddOnes(std::vector<Side> sides) {
  std::sort(sides.begin(), sides.end());
  std::vector<Side> odd;
  for (auto at = sides.begin(); at != sides.end();) {
    const auto next = std::upper_bound(at, sides.end(), *at);
    if ((next - at) % 2 == 1) odd.push_back(*at);
    at = next;
  }
  return odd;
}

void add(const Handle(Poly_PolygonOnTriangulation) & polygon, std::vector<Side>& sides) {
  for (int i = 1; i < polygon->NbNodes(); ++i) {
    if (polygon->Node(i) != polygon->Node(i + 1)) sides.push_back(sideOf(polygon->Node(i), polygon->Node(i + 1)));
  }
}

std::vector<Side> freeSides(const Poly_Triangulation& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * static_cast<std::size_t>(mesh.NbTriangles()));
  for (int i = 1; i <= mesh.NbTriangles(); ++i) {
    int a = 0;
    int b = 0;
    int c = 0;
    mesh.Triangle(i).Get(a, b, c);
    sides.insert(sides.end(), {sideOf(a, b), sideOf(b, c), sideOf(c, a)});
  }
  return oddOnes(std::move(sides));
}

/// False if an edge has no polygon on the mesh.
bool boundarySides(const TopoDS_Face& face, const Handle(Poly_Triangulation) & mesh, const TopLoc_Location& location,
                   std::vector<Side>& sides) {
  for (TopExp_Explorer at(face, TopAbs_EDGE); at.More(); at.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(at.Current());
    const Handle(Poly_PolygonOnTriangulation) polygon = BRep_Tool::PolygonOnTriangulation(edge, mesh, location);
    if (!polygon.IsNull()) {
      add(polygon, sides);
    } else if (!BRep_Tool::Degenerated(edge)) {
      return false;
    }
  }
  sides = oddOnes(std::move(sides));
  return true;
}

/// True if the share of the covered parameters with reversed triangles exceeds kMost.
bool isFolded(const Poly_Triangulation& mesh) {
  constexpr double kMost = 1e-6;
  double there = 0.0;
  double back = 0.0;
  for (int i = 1; i <= mesh.NbTriangles(); ++i) {
    int a = 0;
    int b = 0;
    int c = 0;
    mesh.Triangle(i).Get(a, b, c);
    const gp_XY ab = mesh.UVNode(b).XY() - mesh.UVNode(a).XY();
    const gp_XY ac = mesh.UVNode(c).XY() - mesh.UVNode(a).XY();
    const double area = ab.Crossed(ac);
    (area > 0.0 ? there : back) += std::abs(area);
  }
  return std::min(there, back) > kMost * (there + back);
}

}  // namespace

FaceFault faultOf(const TopoDS_Face& face) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
  if (mesh.IsNull() || mesh->NbTriangles() == 0) return FaceFault::NoTriangles;
  std::vector<Side> boundary;
  if (!boundarySides(face, mesh, location, boundary) || freeSides(*mesh) != boundary) return FaceFault::OpenBoundary;
  return mesh->HasUVNodes() && isFolded(*mesh) ? FaceFault::Folded : FaceFault::None;
}

bool isWound(const TopoDS_Face& face) {
  const BRepAdaptor_Surface surface(face, false);
  if (!surface.IsUPeriodic()) return false;
  const double most = 0.5 * surface.UPeriod();
  const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  for (TopExp_Explorer wire(forward, TopAbs_WIRE); wire.More(); wire.Next()) {
    std::optional<double> first;
    double before = 0.0;
    for (BRepTools_WireExplorer at(TopoDS::Wire(wire.Current()), forward); at.More(); at.Next()) {
      gp_Pnt2d from;
      gp_Pnt2d to;
      BRep_Tool::UVPoints(at.Current(), forward, from, to);
      if (at.Current().Orientation() == TopAbs_REVERSED) std::swap(from, to);
      if (first && std::abs(from.X() - before) > most) return true;
      if (!first) first = from.X();
      before = to.X();
    }
    if (first && std::abs(*first - before) > most) return true;
  }
  return false;
}

}  // namespace glissade
