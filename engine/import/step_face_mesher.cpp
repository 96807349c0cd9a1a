#include "engine/import/step_face_mesher.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <gp_Cylinder.hxx>
#include <optional>
#include <utility>
#include <vector>

#include "engine/import/plane_mesh.h"
#include "engine/import/step_face_boundary.h"

namespace glissade {
namespace {

constexpr std::size_t kMostPoints = 100'000;  ///< points of a face

/// Removes the polygons of the face's edges on its triangles.
void removeTriangles(const TopoDS_Face& face) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation) old = BRep_Tool::Triangulation(face, location);
  if (old.IsNull()) return;
  const BRep_Builder builder;
  for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next()) {
    builder.UpdateEdge(TopoDS::Edge(edge.Current()), Handle(Poly_PolygonOnTriangulation)(), old, location);
  }
}

TopoDS_Face forwardOf(const TopoDS_Face& face) { return TopoDS::Face(face.Oriented(TopAbs_FORWARD)); }

/// An edge of the boundary as indices of the face's points.
struct EdgeNodes {
  TopoDS_Edge edge;
  std::vector<double> parameters;
  std::vector<std::uint32_t> nodes;
};

class FaceMesher {
 public:
  /// `face`: not reversed. `isFlipped`: its triangles are clockwise in the parameters.
  FaceMesher(const TopoDS_Face& face, double deflection, std::vector<FaceBoundary> boundaries, bool isFlipped = false)
      : face_(face),
        surface_(face_, false),
        deflection_(deflection),
        boundaries_(std::move(boundaries)),
        isFlipped_(isFlipped) {}

  FaceMeshing run() {
    const auto isClosed = [&](const FaceBoundary& each) { return isClosedInParameters(each, face_); };
    if (boundaries_.empty() || !std::all_of(boundaries_.begin(), boundaries_.end(), isClosed)) {
      return FaceMeshing::Failed;
    }
    chooseScales();
    for (const FaceBoundary& boundary : boundaries_) addLoop(boundary);
    const auto loops = triangulateLoops(inPlane_, loops_);
    if (!loops) return FaceMeshing::Failed;
    PlaneMesh mesh(inPlane_, loops->triangles);
    if (loops->forced == 0) {
      mesh.makeDelaunay();
      refine(mesh);
    }
    removeTriangles(face_);
    addTriangles(mesh);
    return loops->forced == 0 ? FaceMeshing::InParameters : FaceMeshing::BetweenPoints;
  }

 private:
  /// Chooses scales that convert parameters to about millimetres.
  void chooseScales() {
    double alongU = 0.0;
    double alongV = 0.0;
    for (const FaceBoundary& boundary : boundaries_) {
      for (const BoundaryEdge& edge : boundary) {
        for (const BoundaryPoint& point : edge.points) {
          gp_Pnt on;
          gp_Vec du;
          gp_Vec dv;
          surface_.D1(point.at.X(), point.at.Y(), on, du, dv);
          alongU = std::max(alongU, du.Magnitude());
          alongV = std::max(alongV, dv.Magnitude());
        }
      }
    }
    if (alongU > 0.0 && alongV > 0.0) scales_ = {alongU, alongV};
  }

  /// Adds the points of each edge except its last one, which is the first of the next edge.
  void addLoop(const FaceBoundary& boundary) {
    PlaneLoop loop;
    const std::size_t firstEdge = edges_.size();
    for (const BoundaryEdge& edge : boundary) {
      EdgeNodes nodes{edge.edge, edge.parameters, {}};
      for (std::size_t i = 0; i + 1 < edge.points.size(); ++i) {
        nodes.nodes.push_back(addPoint(edge.points[i]));
        loop.push_back(nodes.nodes.back());
      }
      edges_.push_back(std::move(nodes));
    }
    for (std::size_t i = firstEdge; i < edges_.size(); ++i) {
      const std::size_t next = i + 1 == edges_.size() ? firstEdge : i + 1;
      edges_[i].nodes.push_back(edges_[next].nodes.front());
    }
    loops_.push_back(std::move(loop));
  }

  std::uint32_t addPoint(const BoundaryPoint& point) {
    inPlane_.emplace_back(point.at.X() * scales_[0], point.at.Y() * scales_[1]);
    inSpace_.push_back(point.point);
    return static_cast<std::uint32_t>(inPlane_.size() - 1);
  }

  gp_Pnt onSurface(const PlanePoint& p) const { return surface_.Value(p.x() / scales_[0], p.y() / scales_[1]); }

  /// Largest distance of the triangle's centre and the middles of its sides from the surface, at interpolated
  /// parameters.
  double deviationOf(const PlaneMesh& mesh, const TriangleIndices& t) const {
    constexpr double kThird = 1.0 / 3.0;
    constexpr std::array<std::array<double, 3>, 4> kSamples{
        {{0.5, 0.5, 0.0}, {0.0, 0.5, 0.5}, {0.5, 0.0, 0.5}, {kThird, kThird, kThird}}};
    double most = 0.0;
    for (const auto& share : kSamples) {
      PlanePoint at = PlanePoint::Zero();
      gp_XYZ flat;
      for (std::size_t i = 0; i < 3; ++i) {
        at += share[i] * mesh.points()[t[i]];
        flat += share[i] * inSpace_[t[i]].XYZ();
      }
      most = std::max(most, onSurface(at).Distance(flat));
    }
    return most;
  }

  void refine(PlaneMesh& mesh) {
    constexpr int kMostPasses = 12;
    if (surface_.GetType() == GeomAbs_Plane) return;
    for (int pass = 0; pass < kMostPasses; ++pass) {
      bool changed = false;
      const std::size_t count = mesh.triangles().size();
      for (std::size_t t = 0; t < count && inSpace_.size() < kMostPoints; ++t) {
        if (deviationOf(mesh, mesh.triangles()[t]) <= deflection_ || !mesh.split(t)) continue;
        inSpace_.push_back(onSurface(mesh.points().back()));
        changed = true;
      }
      if (!changed) return;
    }
  }

  void addTriangles(const PlaneMesh& mesh) const {
    const TopLoc_Location location = face_.Location();
    const gp_Trsf back = location.Transformation().Inverted();
    std::vector<TriangleIndices> kept;
    std::copy_if(mesh.triangles().begin(), mesh.triangles().end(), std::back_inserter(kept),
                 [&](const TriangleIndices& t) { return !isWithoutArea(t); });
    const Handle(Poly_Triangulation) triangles =
        new Poly_Triangulation(static_cast<int>(inSpace_.size()), static_cast<int>(kept.size()), true);
    for (std::size_t i = 0; i < inSpace_.size(); ++i) {
      const int node = static_cast<int>(i) + 1;
      triangles->SetNode(node, location.IsIdentity() ? inSpace_[i] : inSpace_[i].Transformed(back));
      const PlanePoint& p = mesh.points()[i];
      triangles->SetUVNode(node, gp_Pnt2d(p.x() / scales_[0], p.y() / scales_[1]));
    }
    for (std::size_t i = 0; i < kept.size(); ++i) {
      auto [a, b, c] = kept[i];
      if (isFlipped_) std::swap(b, c);
      triangles->SetTriangle(static_cast<int>(i) + 1,
                             Poly_Triangle(static_cast<int>(a) + 1, static_cast<int>(b) + 1, static_cast<int>(c) + 1));
    }
    triangles->Deflection(deflection_);
    const BRep_Builder builder;
    builder.UpdateFace(face_, triangles);
    for (std::size_t i = 0; i < edges_.size(); ++i) addPolygon(i, triangles, location);
  }

  /// At a degenerated edge, corners with different parameters are one point.
  bool isWithoutArea(const TriangleIndices& t) const {
    const auto same = [&](std::uint32_t a, std::uint32_t b) { return inSpace_[a].IsEqual(inSpace_[b], 0.0); };
    return same(t[0], t[1]) || same(t[1], t[2]) || same(t[2], t[0]);
  }

  static Handle(Poly_PolygonOnTriangulation) polygonOf(EdgeNodes edge) {
    if (edge.edge.Orientation() == TopAbs_REVERSED) {
      std::reverse(edge.nodes.begin(), edge.nodes.end());
      std::reverse(edge.parameters.begin(), edge.parameters.end());
    }
    const int count = static_cast<int>(edge.nodes.size());
    TColStd_Array1OfInteger nodes(1, count);
    TColStd_Array1OfReal parameters(1, count);
    for (int i = 1; i <= count; ++i) {
      nodes.SetValue(i, static_cast<int>(edge.nodes[static_cast<std::size_t>(i - 1)]) + 1);
      parameters.SetValue(i, edge.parameters[static_cast<std::size_t>(i - 1)]);
    }
    return new Poly_PolygonOnTriangulation(nodes, parameters);
  }

  /// A seam has two polygons.
  void addPolygon(std::size_t index, const Handle(Poly_Triangulation) & triangles,
                  const TopLoc_Location& location) const {
    const TopoDS_Edge& edge = edges_[index].edge;
    const auto other = std::find_if(edges_.begin(), edges_.end(), [&](const EdgeNodes& candidate) {
      return &candidate != &edges_[index] && candidate.edge.IsSame(edge);
    });
    const BRep_Builder builder;
    if (other == edges_.end()) {
      builder.UpdateEdge(edge, polygonOf(edges_[index]), triangles, location);
    } else if (edge.Orientation() == TopAbs_FORWARD) {
      builder.UpdateEdge(edge, polygonOf(edges_[index]), polygonOf(*other), triangles, location);
    }
  }

  TopoDS_Face face_;
  BRepAdaptor_Surface surface_;
  double deflection_;
  std::vector<FaceBoundary> boundaries_;
  bool isFlipped_;
  std::array<double, 2> scales_{1.0, 1.0};
  std::vector<PlanePoint> inPlane_;  ///< points in the parameters; at first those of the boundaries
  std::vector<gp_Pnt> inSpace_;      ///< all points, in the frame of the shape
  std::vector<PlaneLoop> loops_;
  std::vector<EdgeNodes> edges_;
};

bool areOfOneCylinder(const TopoDS_Face& face, const TopoDS_Face& otherFace) {
  constexpr double kSame = 1e-6;  // millimetres
  const BRepAdaptor_Surface one(face, false);
  const BRepAdaptor_Surface other(otherFace, false);
  if (one.GetType() != GeomAbs_Cylinder || other.GetType() != GeomAbs_Cylinder) return false;
  const gp_Cylinder a = one.Cylinder();
  const gp_Cylinder b = other.Cylinder();
  return a.Direct() == b.Direct() && std::abs(a.Radius() - b.Radius()) <= kSame &&
         a.Axis().IsCoaxial(b.Axis(), kSame, kSame) && a.Axis().Direction().Dot(b.Axis().Direction()) > 0.0;
}

/// The orientation of the other faces of the cylinder, in which OpenCASCADE leaves a face whose boundary encloses
/// nothing alone by chance; nothing if there are none.
std::optional<TopAbs_Orientation> orientationOnCylinder(const TopoDS_Face& face, const TopoDS_Shape& beside) {
  for (TopExp_Explorer at(beside, TopAbs_FACE); at.More(); at.Next()) {
    if (areOfOneCylinder(face, TopoDS::Face(at.Current()))) return at.Current().Orientation();
  }
  return std::nullopt;
}

/// The band that two boundaries of one cylinder enclose. `isFlipped`: the faces have the wrong orientation.
std::optional<FaceBoundary> bandOf(const TopoDS_Face& face, const TopoDS_Face& other, bool isFlipped,
                                   EdgePolygons& polygons) {
  std::vector<FaceBoundary> one = boundariesOf(face, polygons);
  std::vector<FaceBoundary> two = boundariesOf(other, polygons);
  if (one.size() != 1 || two.size() != 1) return std::nullopt;
  auto band = joinedBoundary(std::move(one.front()), std::move(two.front()), face);
  return band && isFlipped ? reversed(std::move(*band)) : band;
}

}  // namespace

FaceMeshing meshFace(const TopoDS_Face& face, double deflection, EdgePolygons& polygons) {
  const TopoDS_Face forward = forwardOf(face);
  return FaceMesher(forward, deflection, boundariesOf(forward, polygons)).run();
}

bool meshTogether(const TopoDS_Face& face, const TopoDS_Face& other, const TopoDS_Shape& beside, double deflection,
                  EdgePolygons& polygons) {
  if (face.Orientation() != other.Orientation() || !areOfOneCylinder(face, other)) return false;
  const TopoDS_Face forward = forwardOf(face);
  const auto known = orientationOnCylinder(face, beside);
  for (const bool isFlipped : {false, true}) {
    if (known && isFlipped != (*known != face.Orientation())) continue;
    auto band = bandOf(forward, forwardOf(other), isFlipped, polygons);
    if (!band || FaceMesher(forward, deflection, {std::move(*band)}, isFlipped).run() == FaceMeshing::Failed) continue;
    removeTriangles(other);
    BRep_Builder().UpdateFace(other, Handle(Poly_Triangulation)());
    return true;
  }
  return false;
}

}  // namespace glissade
