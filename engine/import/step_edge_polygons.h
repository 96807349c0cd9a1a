#pragma once

#include <NCollection_DataMap.hxx>
#include <Poly_Triangulation.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Pnt.hxx>
#include <set>
#include <vector>

namespace glissade {

/// An edge as a polygon along the edge's curve.
struct EdgePolygon {
  std::vector<double> parameters;  ///< parameters of the curve
  std::vector<gp_Pnt> points;      ///< in the frame of the shape
};

/// The polygons of edges. Faces that share an edge get the same points bit by bit. Runs in the importing process only.
class EdgePolygons {
 public:
  /// Edges that no triangle touches are divided to be within `deflection` (millimetres) of their curve.
  explicit EdgePolygons(double deflection) : deflection_(deflection) {}

  /// Marks the triangles of a face as unreliable: their polygons are used only if there are no others.
  void markUnreliable(const Handle(Poly_Triangulation) & triangles) { unreliable_.insert(triangles.get()); }

  /// Returns the same polygon at each call. Empty if the edge has no curve.
  const EdgePolygon& of(const TopoDS_Edge& edge);

 private:
  EdgePolygon fromTriangles(const TopoDS_Edge& edge, bool trusted) const;
  EdgePolygon divided(const TopoDS_Edge& edge) const;

  double deflection_;
  std::set<const Poly_Triangulation*> unreliable_;
  NCollection_DataMap<TopoDS_Shape, EdgePolygon, TopTools_ShapeMapHasher> known_;
};

}  // namespace glissade
