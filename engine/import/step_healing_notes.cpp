#include "engine/import/step_healing_notes.h"

#include <BRepAdaptor_Surface.hxx>
#include <sstream>

#include "engine/import/import_protocol.h"

namespace glissade {
namespace {

namespace protocol = import_protocol;

/// The type of the surface in plain words.
CatalogueText typeOf(const TopoDS_Face& face) {
  switch (BRepAdaptor_Surface(face, false).GetType()) {
    case GeomAbs_Plane: return GLISSADE_TEXT("plane");
    case GeomAbs_Cylinder: return GLISSADE_TEXT("cylinder");
    case GeomAbs_Cone: return GLISSADE_TEXT("cone");
    case GeomAbs_Sphere: return GLISSADE_TEXT("sphere");
    case GeomAbs_Torus: return GLISSADE_TEXT("torus");
    case GeomAbs_BSplineSurface: return GLISSADE_TEXT("B-spline surface");
    case GeomAbs_BezierSurface: return GLISSADE_TEXT("Bezier surface");
    case GeomAbs_SurfaceOfRevolution: return GLISSADE_TEXT("surface of revolution");
    case GeomAbs_SurfaceOfExtrusion: return GLISSADE_TEXT("surface of extrusion");
    default: return GLISSADE_TEXT("offset surface");
  }
}

Location placeOf(const HealedFace& healed, const FaceEntities& entities, const std::string& part) {
  const std::string entity = entities.nameOf(healed.face);
  const CatalogueText type = typeOf(healed.face);
  if (part.empty()) return {GLISSADE_TEXT("face %1 (%2)"), {entity, type}};
  return {GLISSADE_TEXT("face %1 (%2) of '%3'"), {entity, type, part}};
}

CatalogueText faultText(FaceFault fault) {
  switch (fault) {
    case FaceFault::NoTriangles: return GLISSADE_TEXT("OpenCASCADE makes no triangles for it");
    case FaceFault::OpenBoundary: return GLISSADE_TEXT("OpenCASCADE's triangles leave its boundary open");
    case FaceFault::Wound: return GLISSADE_TEXT("OpenCASCADE's triangles cross the body beside it");
    default: return GLISSADE_TEXT("OpenCASCADE's triangles overlap on it");
  }
}

std::string inDigits(double value, int digits) {
  std::ostringstream text;
  text.precision(digits);
  text << value;
  return text.str();
}

Message healingText(const HealedFace& healed) {
  const CatalogueText fault = faultText(healed.fault);
  const std::string length = inDigits(healed.deflection, 3);
  switch (healed.meshing) {
    case FaceMeshing::InParameters:
      return {GLISSADE_TEXT("%1; it was triangulated from its boundaries, within %2 mm of its surface"),
              {fault, length}};
    case FaceMeshing::BetweenPoints:
      return {GLISSADE_TEXT("%1, because its boundaries cross; it was triangulated between their points, within %2 mm "
                            "of its surface"),
              {fault, length}};
    case FaceMeshing::WithOther:
      return {GLISSADE_TEXT("%1, because its boundary encloses nothing alone; it was triangulated together with its "
                            "neighbour on the same cylinder"),
              {fault}};
    default: return {GLISSADE_TEXT("%1, and its boundaries cannot be triangulated"), {fault}};
  }
}

Message volumeText(const StepTriangles& triangles) {
  constexpr int kDigits = 7;
  return {GLISSADE_TEXT("its triangles enclose %1 cubic millimetres, and its faces %2: they differ by more than the "
                        "deviation of the triangles explains"),
          {inDigits(triangles.volume, kDigits), inDigits(triangles.exactVolume, kDigits)}};
}

}  // namespace

StepNotes healingNotes(const StepTriangles& triangles, const FaceEntities& entities, const std::string& part) {
  StepNotes notes;
  for (const HealedFace& healed : triangles.healed) {
    const char kind = healed.meshing == FaceMeshing::Failed ? protocol::kLossLine : protocol::kHealedLine;
    notes.push_back({kind, placeOf(healed, entities, part), healingText(healed)});
  }
  if (triangles.volumeDiffers) {
    notes.push_back({protocol::kVolumeLine, {GLISSADE_TEXT("part '%1'"), {part}}, volumeText(triangles)});
  }
  return notes;
}

}  // namespace glissade
