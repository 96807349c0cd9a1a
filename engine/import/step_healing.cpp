#include "engine/import/step_healing.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <iterator>

#include "engine/import/step_deflection.h"
#include "engine/import/step_faces.h"

namespace glissade {
namespace {

/// Triangles that are farther from the surface, in deflections, are at a fault of the face.
constexpr double kFar = 4.0;

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
  return std::all_of(faces.begin(), faces.end(), [](const HealedFace& face) {
    return face.meshing == FaceMeshing::InParameters || face.meshing == FaceMeshing::WithOther;
  });
}

/// The faces of the shape without those that could not be triangulated.
TopoDS_Compound triangulatedOf(const TopoDS_Shape& shape, const std::vector<HealedFace>& healed) {
  TopoDS_Compound compound;
  const BRep_Builder builder;
  builder.MakeCompound(compound);
  for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next()) {
    const bool isFailed = std::any_of(healed.begin(), healed.end(), [&](const HealedFace& each) {
      return each.meshing == FaceMeshing::Failed && each.face.IsSame(at.Current());
    });
    if (!isFailed) builder.Add(compound, at.Current());
  }
  return compound;
}

/// Triangulates faces that could not be alone together with another one.
void meshPairs(std::vector<HealedFace>& faces, const TopoDS_Shape& shape, double deflection, EdgePolygons& polygons) {
  const auto isFailed = [](const HealedFace& face) { return face.meshing == FaceMeshing::Failed; };
  if (std::count_if(faces.begin(), faces.end(), isFailed) < 2) return;
  const TopoDS_Compound beside = triangulatedOf(shape, faces);
  for (auto one = faces.begin(); one != faces.end(); ++one) {
    for (auto other = std::next(one); other != faces.end() && isFailed(*one); ++other) {
      if (!isFailed(*other) || !meshTogether(one->face, other->face, beside, deflection, polygons)) continue;
      one->meshing = FaceMeshing::InParameters;
      other->meshing = FaceMeshing::WithOther;
    }
  }
}

}  // namespace

std::vector<HealedFace> healFaces(const TopoDS_Shape& meshed, double deflection) {
  std::vector<HealedFace> faces;
  EdgePolygons polygons(deflection);
  for (TopExp_Explorer at(meshed, TopAbs_FACE); at.More(); at.Next()) {
    const TopoDS_Face& face = TopoDS::Face(at.Current());
    FaceFault fault = faultOf(face);
    if (fault == FaceFault::None && deflectionOf(face) > kFar * deflection && isWound(face)) fault = FaceFault::Wound;
    if (fault == FaceFault::None) continue;
    faces.push_back({face, fault, FaceMeshing::Failed});
    TopLoc_Location location;
    const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face, location);
    if (!triangles.IsNull()) polygons.markUnreliable(triangles);
  }
  for (HealedFace& healed : faces) healed.meshing = meshFace(healed.face, deflection, polygons);
  meshPairs(faces, meshed, deflection, polygons);
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
