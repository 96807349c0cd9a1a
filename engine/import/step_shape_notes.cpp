#include "engine/import/step_shape_notes.h"

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <vector>

#include "engine/import/import_protocol.h"
#include "engine/import/open_faces.h"

namespace glissade {
namespace {

namespace protocol = import_protocol;

StepNote noteAbout(char kind, const std::string& part, const Message& what) {
  return {kind, part.empty() ? Message() : Message(GLISSADE_TEXT("part '%1'"), {part}), what};
}

/// Number of edges with one face only; a seam joins a face to itself.
int openEdges(const TopoDS_Shape& shape) {
  TopTools_IndexedDataMapOfShapeListOfShape facesOf;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, facesOf);
  int open = 0;
  for (int i = 1; i <= facesOf.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(facesOf.FindKey(i));
    if (facesOf(i).Extent() != 1 || BRep_Tool::Degenerated(edge)) continue;
    open += BRep_Tool::IsClosed(edge, TopoDS::Face(facesOf(i).First())) ? 0 : 1;
  }
  return open;
}

int facesOf(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  return faces.Extent();
}

/// True if the volume is zero up to rounding, compared with the area.
bool hasNoThickness(const StepTriangles& triangles) {
  constexpr double kNone = 1e-9;
  using Point = std::array<double, 3>;
  const auto corner = [&](std::size_t i) {
    const double* p = &triangles.vertices[3 * static_cast<std::size_t>(triangles.indices[i])];
    return Point{p[0] - triangles.vertices[0], p[1] - triangles.vertices[1], p[2] - triangles.vertices[2]};
  };
  const auto cross = [](const Point& u, const Point& v) {
    return Point{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  };
  const auto dot = [](const Point& u, const Point& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; };
  double volume = 0.0;
  double area = 0.0;
  for (std::size_t i = 0; i + 2 < triangles.indices.size(); i += 3) {
    const Point a = corner(i);
    const Point b = corner(i + 1);
    const Point c = corner(i + 2);
    volume += dot(a, cross(b, c)) / 6.0;
    const Point normal = cross({b[0] - a[0], b[1] - a[1], b[2] - a[2]}, {c[0] - a[0], c[1] - a[1], c[2] - a[2]});
    area += 0.5 * std::sqrt(dot(normal, normal));
  }
  return area > 0.0 && std::abs(volume) <= kNone * area * std::sqrt(area);
}

/// Names the faces at which a solid is open, if none of its faces is said to have no triangles.
StepNotes openNotes(const StepTriangles& triangles, const std::string& part) {
  constexpr std::size_t kMostNames = 5;
  const bool isSaid = std::any_of(triangles.healed.begin(), triangles.healed.end(),
                                  [](const HealedFace& face) { return face.meshing == FaceMeshing::Failed; });
  const std::set<std::string> faces =
      isSaid ? std::set<std::string>()
             : openFaces({triangles.vertices, triangles.indices, triangles.faces, triangles.entities});
  if (faces.empty()) return {};
  std::string names;
  for (const std::string& face :
       std::vector(faces.begin(), std::next(faces.begin(), std::min(kMostNames, faces.size()))))
    names += (names.empty() ? "" : ", ") + face;
  if (faces.size() > kMostNames) names += ", …";
  return {noteAbout(protocol::kLossLine, part,
                    {GLISSADE_TEXT("its triangles leave %1 {1|face|faces} open (%2)"), {faces.size(), names}})};
}

}  // namespace

StepNotes shapeNotes(const TopoDS_Shape& shape, const StepTriangles& triangles, const std::string& part) {
  if (shape.ShapeType() != TopAbs_SOLID) {
    const int open = openEdges(shape);
    if (open == 0) return {};
    return {noteAbout(protocol::kShapeLine, part,
                      {GLISSADE_TEXT("is no solid: its faces (%1) bound nothing, %2 of their edges are open"),
                       {facesOf(shape), open}})};
  }
  if (!hasNoThickness(triangles)) return openNotes(triangles, part);
  return {noteAbout(protocol::kShapeLine, part, GLISSADE_TEXT("has no thickness: its faces enclose no volume"))};
}

StepNotes curveNotes(const TopoDS_Shape& product, const std::string& part) {
  TopTools_IndexedMapOfShape curves;
  for (TopExp_Explorer edge(product, TopAbs_EDGE, TopAbs_FACE); edge.More(); edge.Next()) curves.Add(edge.Current());
  if (curves.Extent() == 0) return {};
  return {noteAbout(protocol::kCurveLine, part,
                    {GLISSADE_TEXT("has curves that lie on no face (%1): they are left out"), {curves.Extent()}})};
}

}  // namespace glissade
