#include "engine/import/step_mirrors.h"

#include <Interface_InterfaceModel.hxx>
#include <StepGeom_Axis2Placement3d.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepGeom_CartesianTransformationOperator3d.hxx>
#include <StepGeom_Direction.hxx>
#include <StepRepr_RepresentationMap.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <cmath>
#include <gp_XYZ.hxx>
#include <optional>

#include "engine/import/import_refusal.h"

namespace glissade {
namespace {

using Operator = Handle(StepGeom_CartesianTransformationOperator3d);

/// Directions with a smaller sine span no plane, and smaller squares of lengths count as zero.
constexpr double kLeastSine = 1e-9;
constexpr double kRigid = 1e-9;
/// Limits of plausible scales of a product.
constexpr double kLeastScale = 1e-6;
constexpr double kMostScale = 1e6;

std::optional<gp_XYZ> axisOf(const Handle(StepGeom_Direction) & direction) {
  if (direction.IsNull() || direction->NbDirectionRatios() != 3) return std::nullopt;
  const gp_XYZ axis(direction->DirectionRatiosValue(1), direction->DirectionRatiosValue(2),
                    direction->DirectionRatiosValue(3));
  const double length = axis.Modulus();
  return length > kLeastSine ? std::optional(axis / length) : std::nullopt;
}

/// True if the operator mirrors. A missing axis is completed so that nothing is mirrored.
bool isMirror(const Operator& of) {
  const auto x = axisOf(of->Axis1());
  const auto y = axisOf(of->Axis2());
  const auto z = axisOf(of->Axis3());
  return x && y && z && x->Crossed(*y).Dot(*z) < 0.0;
}

bool isScaled(const Operator& of) { return of->HasScale() && !(std::abs(of->Scale() - 1.0) < kRigid); }

[[noreturn]] void refuse(const std::string& name, const Operator& of) {
  const CatalogueText what =
      isMirror(of)   ? GLISSADE_TEXT("%1 mirrors a part in a way that cannot be read: write it as a part of its own")
      : isScaled(of) ? GLISSADE_TEXT("%1 scales a part in a way that cannot be read: write it as a part of its own")
                     : GLISSADE_TEXT("%1 places a part in a way that cannot be read: write it as a part of its own");
  throw ImportRefusal{{what, {name}}};
}

/// The axes of ISO 10303-42: z as given, x perpendicular to it. Nothing if both have one direction.
std::optional<gp_Mat> rightHanded(const std::optional<gp_XYZ>& givenX, const std::optional<gp_XYZ>& givenZ) {
  const gp_XYZ z = givenZ.value_or(gp_XYZ(0.0, 0.0, 1.0));
  gp_XYZ x = givenX.value_or(std::abs(z.X()) < 0.9 ? gp_XYZ(1.0, 0.0, 0.0) : gp_XYZ(0.0, 1.0, 0.0));
  x -= x.Dot(z) * z;
  if (x.Modulus() < kLeastSine) return std::nullopt;
  x.Normalize();
  return gp_Mat(x, z.Crossed(x), z);
}

std::optional<gp_XYZ> pointOf(const Handle(StepGeom_CartesianPoint) & point) {
  if (point.IsNull() || point->NbCoordinates() != 3) return std::nullopt;
  return gp_XYZ(point->CoordinatesValue(1), point->CoordinatesValue(2), point->CoordinatesValue(3));
}

using Placement = Handle(StepGeom_Axis2Placement3d);

Placement originOf(const Handle(StepRepr_MappedItem) & item) {
  return item->MappingSource().IsNull() ? Placement() : Placement::DownCast(item->MappingSource()->MappingOrigin());
}

/// True if the origin of a mapping is not that of its frame; OpenCASCADE ignores it for an operator.
bool isAside(const Placement& origin) {
  const auto at = origin.IsNull() ? std::nullopt : pointOf(origin->Location());
  const auto axes =
      origin.IsNull() ? std::nullopt : rightHanded(axisOf(origin->RefDirection()), axisOf(origin->Axis()));
  if (!at || !axes) return false;
  return at->Modulus() > 0.0 || std::abs((*axes)(1, 1) - 1.0) + std::abs((*axes)(3, 3) - 1.0) > kRigid;
}

/// The datum that was applied last to a shape.
Handle(TopLoc_Datum3D) outermost(TopLoc_Location location) {
  if (location.IsIdentity()) return nullptr;
  while (!location.NextLocation().IsIdentity()) location = location.NextLocation();
  return location.FirstPower() == 1 ? location.FirstDatum() : nullptr;
}

/// The factor of a location that is a translation along x by that factor.
std::optional<double> factorOf(const gp_Trsf& placement) {
  const gp_XYZ shift = placement.TranslationPart();
  const gp_Mat turn = placement.VectorialPart();
  const double rest = std::abs(shift.Y()) + std::abs(shift.Z());
  const bool turned = std::abs(turn.Value(1, 1) - 1.0) + std::abs(turn.Value(2, 2) - 1.0) > kRigid;
  if (turned || !(shift.X() > 0.0) || rest > kRigid * shift.X()) return std::nullopt;
  return shift.X();
}

/// The transformation from the axes of the mapping to those of the operator; nothing if one of them has none.
std::optional<MirroredInstances::Similarity> similarityOf(const Operator& of, const Placement& from) {
  const auto axes = rightHanded(axisOf(of->Axis1()), axisOf(of->Axis3()));
  const auto shift = pointOf(of->LocalOrigin());
  const double scale = of->HasScale() ? of->Scale() : 1.0;
  if (!axes || !shift || !(scale > kLeastScale && scale < kMostScale) || from.IsNull()) return std::nullopt;
  const auto fromAxes = rightHanded(axisOf(from->RefDirection()), axisOf(from->Axis()));
  const auto fromPoint = pointOf(from->Location());
  if (!fromAxes || !fromPoint) return std::nullopt;
  gp_Mat linear = *axes;
  if (isMirror(of)) linear.SetCol(2, -1.0 * axes->Column(2));
  linear = scale * linear * fromAxes->Transposed();
  return MirroredInstances::Similarity{linear, *shift - linear * *fromPoint};
}

/// Replaces the operator by a translation along x, without turn, mirror and scale, so that there is always a location.
void makePlain(const Operator& of) {
  of->UnSetAxis1();
  of->UnSetAxis2();
  of->UnSetAxis3();
  of->UnSetScale();
  const Handle(StepGeom_CartesianPoint) aside = new StepGeom_CartesianPoint;
  aside->Init3D(new TCollection_HAsciiString(""), 1.0, 0.0, 0.0);
  of->SetLocalOrigin(aside);
}

}  // namespace

MirroredInstances::MirroredInstances(const STEPCAFControl_Reader& reader) {
  const Handle(Interface_InterfaceModel) model = reader.Reader().WS()->Model();
  std::map<Operator, std::string> special;
  const auto note = [&](const Operator& of) { special.emplace(of, model->StringLabel(of)->ToCString()); };
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto of = Operator::DownCast(model->Value(i));
    if (!of.IsNull() && (isMirror(of) || isScaled(of))) note(of);
    const auto item = Handle(StepRepr_MappedItem)::DownCast(model->Value(i));
    const auto target = item.IsNull() ? Operator() : Operator::DownCast(item->MappingTarget());
    if (!target.IsNull() && isAside(originOf(item))) note(target);
  }
  std::set<Operator> used;
  for (int i = 1; i <= model->NbEntities() && !special.empty(); ++i) {
    const auto item = Handle(StepRepr_MappedItem)::DownCast(model->Value(i));
    const auto target = item.IsNull() ? Operator() : Operator::DownCast(item->MappingTarget());
    const auto known = target.IsNull() ? special.end() : special.find(target);
    if (known == special.end()) continue;
    used.insert(target);
    const auto placed = similarityOf(target, originOf(item));
    if (!placed) refuse(known->second, target);
    instances_.push_back({item, known->second, *placed});
  }
  for (const auto& [of, name] : special) {
    if (used.count(of) == 0) refuse(name, of);
    makePlain(of);
  }
}

void MirroredInstances::locate(const STEPCAFControl_Reader& reader) {
  const auto process = reader.Reader().WS()->TransferReader()->TransientProcess();
  for (const Instance& instance : instances_) {
    const TopoDS_Shape shape = TransferBRep::ShapeResult(process, instance.item);
    const Handle(TopLoc_Datum3D) datum = shape.IsNull() ? nullptr : outermost(shape.Location());
    const auto factor = datum.IsNull() ? std::nullopt : factorOf(datum->Trsf());
    if (!factor) {
      throw ImportRefusal{{GLISSADE_TEXT("%1 places a part that could not be made"), {instance.operatorName}}};
    }
    trueOf_[datum.get()] = {instance.placed.linear, *factor * instance.placed.shift};
  }
}

StepPlacement MirroredInstances::placementOf(const TopLoc_Location& location, const std::string& path) {
  const auto unusual = [&path] { return ImportRefusal{{GLISSADE_TEXT("'%1' is distorted by its assembly"), {path}}}; };
  Similarity whole;
  whole.linear.SetIdentity();
  bool isTrue = false;
  // Applies the placements from the innermost outwards.
  for (TopLoc_Location rest = location; !rest.IsIdentity(); rest = rest.NextLocation()) {
    const auto known = trueOf_.find(rest.FirstDatum().get());
    if (known != trueOf_.end() && rest.FirstPower() != 1) throw unusual();
    if (known != trueOf_.end()) {
      used_.insert(known->first);
      isTrue = true;
      whole = {known->second.linear * whole.linear, known->second.linear * whole.shift + known->second.shift};
      continue;
    }
    const gp_Trsf own = rest.FirstDatum()->Trsf().Powered(rest.FirstPower());
    const gp_Mat turn = own.VectorialPart();
    whole = {turn * whole.linear, turn * whole.shift + own.TranslationPart()};
  }
  const double determinant = isTrue ? whole.linear.Determinant() : 1.0;
  StepPlacement placement{location.Transformation(), std::cbrt(std::abs(determinant)), determinant < 0.0};
  if (std::abs(placement.scale - 1.0) < kRigid) placement.scale = 1.0;
  if (isTrue) {
    gp_Mat turn = whole.linear / placement.scale;
    if (placement.mirrored) turn.SetCol(1, -1.0 * turn.Column(1));
    placement.rigid.SetValues(turn(1, 1), turn(1, 2), turn(1, 3), whole.shift.X(), turn(2, 1), turn(2, 2), turn(2, 3),
                              whole.shift.Y(), turn(3, 1), turn(3, 2), turn(3, 3), whole.shift.Z());
  }
  const bool rigid = std::abs(placement.rigid.ScaleFactor() - 1.0) < kRigid &&
                     std::abs(placement.rigid.VectorialPart().Determinant() - 1.0) < kRigid;
  if (!rigid) throw unusual();
  return placement;
}

void MirroredInstances::demandAllUsed() const {
  for (const auto& [datum, placed] : trueOf_) {
    if (used_.count(datum) == 0) {
      throw ImportRefusal{GLISSADE_TEXT("a mirrored or scaled part was not found in its assembly")};
    }
  }
}

}  // namespace glissade
