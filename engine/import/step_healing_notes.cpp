#include "engine/import/step_healing_notes.h"

#include <BRepAdaptor_Surface.hxx>
#include <sstream>

#include "engine/import/import_protocol.h"

namespace glissade {
namespace {

namespace protocol = import_protocol;

/// The type of the surface in plain words.
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
  const std::string type = typeOf(healed.face);
  if (part.empty()) return "face " + entity + " (" + type + ")";
  return "face " + entity + " (" + type + ") of '" + part + "'";
}

std::string faultText(FaceFault fault) {
  switch (fault) {
    case FaceFault::NoTriangles: return "OpenCASCADE makes no triangles for it";
    case FaceFault::OpenBoundary: return "OpenCASCADE's triangles leave its boundary open";
    default: return "OpenCASCADE's triangles overlap on it";
  }
}

std::string inDigits(double value, int digits) {
  std::ostringstream text;
  text.precision(digits);
  text << value;
  return text.str();
}

std::string healingText(const HealedFace& healed) {
  const std::string fault = faultText(healed.fault);
  const std::string length = inDigits(healed.deflection, 3);
  switch (healed.meshing) {
    case FaceMeshing::InParameters:
      return fault + "; it was triangulated from its boundaries, within " + length + " mm of its surface";
    case FaceMeshing::BetweenPoints:
      return fault + ", because its boundaries cross; it was triangulated between their points, within " + length +
             " mm of its surface";
    default: return fault + ", and its boundaries cannot be triangulated";
  }
}

std::string volumeText(const StepTriangles& triangles) {
  constexpr int kDigits = 7;
  return "its triangles enclose " + inDigits(triangles.volume, kDigits) + " cubic millimetres, and its faces " +
         inDigits(triangles.exactVolume, kDigits) +
         ": they differ by more than the deviation of the triangles explains";
}

std::string lineOf(char kind, const std::string& where, const std::string& what) {
  return std::string(1, kind) + "\t" + where + "\t" + what;
}

}  // namespace

std::vector<std::string> healingNotes(const StepTriangles& triangles, const FaceEntities& entities,
                                      const std::string& part) {
  std::vector<std::string> notes;
  for (const HealedFace& healed : triangles.healed) {
    const char kind = healed.meshing == FaceMeshing::Failed ? protocol::kLossLine : protocol::kHealedLine;
    notes.push_back(lineOf(kind, placeOf(healed, entities, part), healingText(healed)));
  }
  if (triangles.volumeDiffers) {
    notes.push_back(lineOf(protocol::kVolumeLine, "part '" + part + "'", volumeText(triangles)));
  }
  return notes;
}

}  // namespace glissade
