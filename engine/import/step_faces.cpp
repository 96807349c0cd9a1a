#include "engine/import/step_faces.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>
#include <limits>
#include <vector>

#include "engine/geometry/nearest_point.h"
#include "engine/geometry/node_samples.h"
#include "engine/geometry/surface_deviation.h"
#include "engine/import/import_protocol.h"

namespace glissade {
namespace {

using Kind = SurfaceFace::Kind;
/// Deflection below which it is only the rounding of coordinates, millimetres.
constexpr double kRounding = 1e-9;
using Corners = std::array<Vector3, 3>;

Vector3 toVector(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }
Vector3 toVector(const gp_Dir& d) { return {d.X(), d.Y(), d.Z()}; }

/// The kind and sizes of the surface, without its deflection.
SurfaceFace kindOf(const BRepAdaptor_Surface& surface) {
  const auto about = [](Kind kind, const gp_Ax1& axis, double radius, double second) {
    return SurfaceFace{kind, toVector(axis.Location()), toVector(axis.Direction()), radius, second};
  };
  switch (surface.GetType()) {
    case GeomAbs_Plane: return about(Kind::Plane, surface.Plane().Axis(), 0.0, 0.0);
    case GeomAbs_Cylinder: return about(Kind::Cylinder, surface.Cylinder().Axis(), surface.Cylinder().Radius(), 0.0);
    case GeomAbs_Cone: {
      const gp_Cone cone = surface.Cone();
      SurfaceFace face = about(Kind::Cone, cone.Axis(), cone.RefRadius(), std::abs(cone.SemiAngle()));
      if (cone.SemiAngle() < 0.0) face.axis = -face.axis;  // the radius grows along the axis
      return face;
    }
    case GeomAbs_Sphere: return about(Kind::Sphere, surface.Sphere().Position().Axis(), surface.Sphere().Radius(), 0.0);
    case GeomAbs_Torus:
      return about(Kind::Torus, surface.Torus().Axis(), surface.Torus().MajorRadius(), surface.Torus().MinorRadius());
    default: return {};
  }
}

/// The stated surface; a free surface if its sizes are out of range. A torus that meets itself, as barrels of rollers
/// are drawn (DEGENERATE_TOROIDAL_SURFACE), is a free surface: it has two distances from its circle.
SurfaceFace stated(const BRepAdaptor_Surface& surface) {
  constexpr double kLargest = import_protocol::kLargestFace / import_protocol::kMillimetre;
  const SurfaceFace face = kindOf(surface);
  const bool meetsItself = face.kind == Kind::Torus && face.second >= face.radius;
  const double size = std::max({face.point.cwiseAbs().maxCoeff(), face.radius, face.second});
  return size <= kLargest && !meetsItself ? face : SurfaceFace();
}

/// The triangles of a face in the frame of its shape.
class FaceTriangles {
 public:
  FaceTriangles(const Handle(Poly_Triangulation) & mesh, const gp_Trsf& placement) : mesh_(mesh) {
    nodes_.reserve(static_cast<std::size_t>(mesh->NbNodes()));
    for (int i = 1; i <= mesh->NbNodes(); ++i) nodes_.push_back(toVector(mesh->Node(i).Transformed(placement)));
  }

  const Vector3& node(int number) const { return nodes_[static_cast<std::size_t>(number - 1)]; }

  /// Calls a function with the numbers of the three nodes of each triangle.
  template <class Function>
  void forEach(const Function& look) const {
    std::array<int, 3> nodes{};
    for (int i = 1; i <= mesh_->NbTriangles(); ++i) {
      mesh_->Triangle(i).Get(nodes[0], nodes[1], nodes[2]);
      look(nodes);
    }
  }

  Corners cornersOf(const std::array<int, 3>& nodes) const { return {node(nodes[0]), node(nodes[1]), node(nodes[2])}; }

 private:
  Handle(Poly_Triangulation) mesh_;
  std::vector<Vector3> nodes_;
};

/// Upper bound on the distance of a point from the surface: three Gauss-Newton steps from these parameters.
double distanceFrom(const BRepAdaptor_Surface& surface, gp_XY at, const Vector3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (int step = 0; step <= 3; ++step) {
    gp_Pnt point;
    gp_Vec alongU;
    gp_Vec alongV;
    surface.D1(at.X(), at.Y(), point, alongU, alongV);
    const gp_Vec rest(point, gp_Pnt(p.x(), p.y(), p.z()));
    least = std::min(least, rest.Magnitude());
    const double uu = alongU.SquareMagnitude();
    const double uv = alongU.Dot(alongV);
    const double vv = alongV.SquareMagnitude();
    const double determinant = uu * vv - uv * uv;
    if (!(determinant > 1e-12 * uu * vv)) break;
    const double u = alongU.Dot(rest);
    const double v = alongV.Dot(rest);
    at += gp_XY(vv * u - uv * v, uu * v - uv * u) / determinant;
  }
  return least;
}

/// The deviation of a triangle. Quick: from the surface at interpolated parameters, which is too large for unequal
/// steps on the surface; else from the nearest points of the surface.
template <bool isQuick>
double deviationOfFree(const BRepAdaptor_Surface& surface, const Corners& corners, const std::array<gp_XY, 3>& at) {
  constexpr int kParts = 4;
  TriangleSamples<kParts> samples;
  for (int i = 0; i <= kParts; ++i) {
    for (int j = 0; i + j <= kParts; ++j) {
      const int k = kParts - i - j;
      const gp_XY between = (at[0] * i + at[1] * j + at[2] * k) / kParts;
      if constexpr (isQuick) {
        const Vector3 onSurface = toVector(surface.Value(between.X(), between.Y()));
        samples.at(i, j) = (nearestPoint(corners, onSurface) - onSurface).norm();
      } else {
        samples.at(i, j) = distanceFrom(surface, between, (i * corners[0] + j * corners[1] + k * corners[2]) / kParts);
      }
    }
  }
  return samples.largest();
}

double deviationOfFree(const BRepAdaptor_Surface& surface, const Handle(Poly_Triangulation) & mesh,
                       const FaceTriangles& triangles) {
  double most = 0.0;
  triangles.forEach([&](const std::array<int, 3>& nodes) {
    const Corners corners = triangles.cornersOf(nodes);
    std::array<gp_XY, 3> at;
    for (std::size_t i = 0; i < 3; ++i) at[i] = mesh->UVNode(nodes[i]).XY();
    const double quick = deviationOfFree<true>(surface, corners, at);
    if (quick > most) most = std::max(most, std::min(quick, deviationOfFree<false>(surface, corners, at)));
  });
  return most;
}

/// Deviation of the curve from the straight line between two nodes, at two of its parameters.
double deviationOfCurve(const BRepAdaptor_Curve& curve, double first, double last, const Vector3& from,
                        const Vector3& to) {
  const auto distanceAt = [&](double share) {
    const Vector3 p = toVector(curve.Value(first + share * (last - first)));
    return (nearestOnSegment(from, to, p) - p).norm();
  };
  if (curve.GetType() == GeomAbs_Circle) return distanceAt(0.5);
  constexpr int kParts = 4;
  LineSamples<kParts> samples;
  for (int i = 0; i <= kParts; ++i) samples.at(i) = distanceAt(i / static_cast<double>(kParts));
  return samples.largest();
}

double deviationOfBoundary(const TopoDS_Face& face, const Handle(Poly_Triangulation) & mesh,
                           const FaceTriangles& triangles) {
  TopLoc_Location location;
  BRep_Tool::Triangulation(face, location);
  double most = 0.0;
  for (TopExp_Explorer at(face, TopAbs_EDGE); at.More(); at.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(at.Current());
    const Handle(Poly_PolygonOnTriangulation) polygon = BRep_Tool::PolygonOnTriangulation(edge, mesh, location);
    if (polygon.IsNull() || !polygon->HasParameters() || BRep_Tool::Degenerated(edge)) continue;
    const BRepAdaptor_Curve curve(edge);
    if (curve.GetType() == GeomAbs_Line) continue;
    for (int i = 1; i < polygon->NbNodes(); ++i) {
      most = std::max(most, deviationOfCurve(curve, polygon->Parameter(i), polygon->Parameter(i + 1),
                                             triangles.node(polygon->Node(i)), triangles.node(polygon->Node(i + 1))));
    }
  }
  return most;
}

}  // namespace

SurfaceFace measuredFace(const TopoDS_Face& face, const Handle(Poly_Triangulation) & mesh, const gp_Trsf& placement) {
  const BRepAdaptor_Surface surface(face, false);
  SurfaceFace measured = stated(surface);
  const bool isInwards = (face.Orientation() == TopAbs_REVERSED) != placement.IsNegative();
  if (measured.kind == Kind::Plane && isInwards == surface.Plane().Direct()) measured.axis = -measured.axis;
  const FaceTriangles triangles(mesh, placement);
  if (measured.kind == Kind::Free) {
    measured.deflection = deviationOfFree(surface, mesh, triangles);
  } else {
    triangles.forEach([&](const std::array<int, 3>& nodes) {
      measured.deflection = std::max(measured.deflection, deviationFrom(measured, triangles.cornersOf(nodes)));
    });
  }
  if (measured.kind != Kind::Plane) {
    measured.deflection = std::max(measured.deflection, deviationOfBoundary(face, mesh, triangles));
  }
  if (measured.deflection < kRounding) measured.deflection = 0.0;
  return measured;
}

}  // namespace glissade
