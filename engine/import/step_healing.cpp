#include "engine/import/step_healing.h"

#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>

namespace glissade {

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
    if (!triangles.IsNull()) polygons.distrust(triangles);
  }
  for (HealedFace& healed : faces) healed.meshing = meshFace(healed.face, deflection, polygons);
  return faces;
}

}  // namespace glissade
