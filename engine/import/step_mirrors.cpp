#include "engine/import/step_mirrors.h"

#include <Interface_InterfaceModel.hxx>
#include <StepGeom_CartesianTransformationOperator3d.hxx>
#include <StepGeom_Direction.hxx>
#include <XSControl_WorkSession.hxx>
#include <cmath>
#include <gp_XYZ.hxx>

namespace glissade {
namespace {

std::optional<gp_XYZ> axisOf(const Handle(StepGeom_Direction) & direction) {
  if (direction.IsNull() || direction->NbDirectionRatios() != 3) return std::nullopt;
  return gp_XYZ(direction->DirectionRatiosValue(1), direction->DirectionRatiosValue(2),
                direction->DirectionRatiosValue(3));
}

/// An axis that is left out is made so that nothing is mirrored.
bool isMirror(const Handle(StepGeom_CartesianTransformationOperator3d) & of) {
  const auto x = axisOf(of->Axis1());
  const auto y = axisOf(of->Axis2());
  const auto z = axisOf(of->Axis3());
  return x && y && z && x->Crossed(*y).Dot(*z) < 0.0;
}

bool isScaled(const Handle(StepGeom_CartesianTransformationOperator3d) & of) {
  return of->HasScale() && !(std::abs(of->Scale() - 1.0) < 1e-9);
}

}  // namespace

std::optional<std::string> mirrorOrScaleIn(const STEPCAFControl_Reader& reader) {
  const Handle(Interface_InterfaceModel) model = reader.Reader().WS()->Model();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto placement = Handle(StepGeom_CartesianTransformationOperator3d)::DownCast(model->Value(i));
    if (placement.IsNull()) continue;
    const char* what = isMirror(placement) ? "mirrors" : isScaled(placement) ? "scales" : nullptr;
    if (what == nullptr) continue;
    return std::string(model->StringLabel(placement)->ToCString()) + " " + what +
           " a part, which the library that reads STEP does not do: write the " +
           (isMirror(placement) ? "mirrored" : "scaled") + " part as a part of its own";
  }
  return std::nullopt;
}

}  // namespace glissade
