#include "engine/import/step_healing.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <algorithm>

#include "engine/import/step_deflection.h"
#include "engine/import/step_faces.h"

namespace glissade {
namespace {

void addTriangles(const TopoDS_Shape& shape, double deflection) {
  IMeshTools_Parameters parameters;
  parameters.Deflection = deflection;
  parameters.Angle = kStepAngle;
  parameters.InParallel = false;
  const BRepMesh_IncrementalMesh meshed(shape, parameters);
}

/// Meshes the finest faces first: OpenCASCADE keeps triangles that are finer than requested, and their edges.
void mesh(const TopoDS_Shape& shape, const Fineness& fineness, double share) {
  BRepTools::Clean(shape);  // a face of two solids may have the triangles of the other solid
  for (const auto& [deflection, faces] : fineness.fine) addTriangles(faces, share * deflection);
  addTriangles(shape, share * fineness.deflection);
}

double deflectionOf(const TopoDS_Face& face) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face, location);
  return triangles.IsNull() ? 0.0 : measuredFace(face, triangles, location.Transformation()).deflection;
}

bool areSound(const std::vector<HealedFace>& faces) {
  return std::all_of(faces.begin(), faces.end(),
                     [](const HealedFace& face) { return face.meshing == FaceMeshing::InParameters; });
}

}  // namespace

std::vector<HealedFace> healFaces(const TopoDS_Shape& meshed, double deflection) {
  std::vector<HealedFace> faces;
  EdgePolygons polygons(deflection);
  for (TopExp_Explorer at(meshed, TopAbs_FACE); at.More(); at.Next()) {
    const TopoDS_Face& face = TopoDS::Face(at.Current());
    const FaceFault fault = faultOf(face);
    if (fault == FaceFault::None) continue;
    faces.push_back({face, fault, FaceMeshing::Failed});
    TopLoc_Location location;
    const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face, location);
    if (!triangles.IsNull()) polygons.markUnreliable(triangles);
  }
  for (HealedFace& healed : faces) healed.meshing = meshFace(healed.face, deflection, polygons);
  for (HealedFace& healed : faces) healed.deflection = deflectionOf(healed.face);
  return faces;
}

std::vector<HealedFace> meshAndHeal(const TopoDS_Shape& shape, const Fineness& fineness) {
  for (const double share : {1.0, 0.5, 0.25}) {
    mesh(shape, fineness, share);
    std::vector<HealedFace> faces = healFaces(shape, share * fineness.deflection);
    if (areSound(faces)) return faces;
  }
  mesh(shape, fineness, 1.0);
  return healFaces(shape, fineness.deflection);
}

}  // namespace glissade
