#include "engine/import/step_edge_polygons.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_TangentialDeflection.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>

#include "engine/import/step_deflection.h"

namespace glissade {

const EdgePolygon& EdgePolygons::of(const TopoDS_Edge& edge) {
  if (const EdgePolygon* known = known_.Seek(edge)) return *known;
  const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
  EdgePolygon polygon = fromTriangles(forward, true);
  if (polygon.points.empty()) polygon = fromTriangles(forward, false);
  if (polygon.points.empty()) polygon = divided(forward);
  known_.Bind(edge, polygon);
  return known_.Find(edge);
}

EdgePolygon EdgePolygons::fromTriangles(const TopoDS_Edge& edge, bool trusted) const {
  EdgePolygon polygon;
  for (int i = 1;; ++i) {
    Handle(Poly_PolygonOnTriangulation) nodes;
    Handle(Poly_Triangulation) triangles;
    TopLoc_Location location;
    BRep_Tool::PolygonOnTriangulation(edge, nodes, triangles, location, i);
    if (nodes.IsNull() || triangles.IsNull()) return polygon;
    if (!nodes->HasParameters() || trusted == (unreliable_.count(triangles.get()) > 0)) continue;
    for (int n = 1; n <= nodes->NbNodes(); ++n) {
      polygon.parameters.push_back(nodes->Parameter(n));
      polygon.points.push_back(triangles->Node(nodes->Node(n)).Transformed(location.Transformation()));
    }
    return polygon;
  }
}

EdgePolygon EdgePolygons::divided(const TopoDS_Edge& edge) const {
  EdgePolygon polygon;
  TopoDS_Vertex first;
  TopoDS_Vertex last;
  TopExp::Vertices(edge, first, last);
  double from = 0.0;
  double to = 0.0;
  if (first.IsNull() || last.IsNull() || BRep_Tool::Curve(edge, from, to).IsNull()) return polygon;
  const BRepAdaptor_Curve curve(edge);
  const GCPnts_TangentialDeflection points(curve, kStepAngle, deflection_, 2);
  for (int i = 1; i <= points.NbPoints(); ++i) {
    polygon.parameters.push_back(points.Parameter(i));
    polygon.points.push_back(points.Value(i));
  }
  polygon.points.front() = BRep_Tool::Pnt(first);
  polygon.points.back() = BRep_Tool::Pnt(last);
  return polygon;
}

}  // namespace glissade
