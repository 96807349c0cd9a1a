#include "engine/import/step_healing_notes.h"

#include <BRepAdaptor_Surface.hxx>
#include <sstream>

#include "engine/import/import_protocol.h"

namespace glissade {
namespace {

namespace protocol = import_protocol;

/// As STEP and OpenCASCADE call it, in plain words.
std::string typeOf(const TopoDS_Face& face) {
  switch (BRepAdaptor_Surface(face, false).GetType()) {
    case GeomAbs_Plane: return "plane";
    case GeomAbs_Cylinder: return "cylinder";
    case GeomAbs_Cone: return "cone";
    case GeomAbs_Sphere: return "sphere";
    case GeomAbs_Torus: return "torus";
    case GeomAbs_BSplineSurface: return "B-spline surface";
    case GeomAbs_BezierSurface: return "Bezier surface";
    case GeomAbs_SurfaceOfRevolution: return "surface of revolution";
    case GeomAbs_SurfaceOfExtrusion: return "surface of extrusion";
    default: return "offset surface";
  }
}

std::string placeOf(const HealedFace& healed, const FaceEntities& entities, const std::string& part) {
  const std::string entity = entities.nameOf(healed.face);
  return "face " + (entity.empty() ? "" : entity + " ") + "(" + typeOf(healed.face) + ")" +
         (part.empty() ? "" : " of '" + part + "'");
}

std::string faultText(FaceFault fault) {
  switch (fault) {
    case FaceFault::NoTriangles: return "OpenCASCADE makes no triangles for it";
    case FaceFault::OpenBoundary: return "OpenCASCADE's triangles leave its boundary open";
    default: return "OpenCASCADE's triangles overlap on it";
  }
}

std::string lengthText(double millimetres) {
  std::ostringstream text;
  text.precision(3);
  text << millimetres;
  return text.str();
}

std::string healingText(const HealedFace& healed) {
  const std::string fault = faultText(healed.fault);
  const std::string length = lengthText(healed.deflection);
  switch (healed.meshing) {
    case FaceMeshing::InParameters:
      return fault + "; it was triangulated from its boundaries, within " + length + " mm of its surface";
    case FaceMeshing::BetweenPoints:
      return fault + ", because its boundaries cross; it was triangulated between their points, within " + length +
             " mm of its surface";
    default: return fault + ", and its boundaries cannot be triangulated";
  }
}

}  // namespace

std::vector<std::string> healingNotes(const StepTriangles& triangles, const FaceEntities& entities,
                                      const std::string& part) {
  std::vector<std::string> notes;
  for (const HealedFace& healed : triangles.healed) {
    const char kind = healed.meshing == FaceMeshing::Failed ? protocol::kLossLine : protocol::kHealedLine;
    notes.push_back(kind + ("\t" + placeOf(healed, entities, part)) + "\t" + healingText(healed));
  }
  if (triangles.volumeDiffers) {
    notes.push_back(protocol::kVolumeLine + ("\tpart '" + part) + "'\tits triangles enclose " +
                    lengthText(triangles.volume) + " mm³, and its faces " + lengthText(triangles.exactVolume) +
                    " mm³: that is more than the deviation of its triangles explains");
  }
  return notes;
}

}  // namespace glissade
