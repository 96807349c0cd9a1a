#include "engine/import/step_validation.h"

#include <STEPConstruct_ValidationProps.hxx>
#include <StepBasic_ConversionBasedUnit.hxx>
#include <StepBasic_DerivedUnit.hxx>
#include <StepBasic_DerivedUnitElement.hxx>
#include <StepBasic_MeasureWithUnit.hxx>
#include <StepBasic_SiUnit.hxx>
#include <StepBasic_Unit.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepRepr_MeasureRepresentationItem.hxx>
#include <StepRepr_PropertyDefinition.hxx>
#include <StepRepr_PropertyDefinitionRepresentation.hxx>
#include <StepRepr_Representation.hxx>
#include <TColStd_SequenceOfTransient.hxx>
#include <XSControl_WorkSession.hxx>
#include <cmath>
#include <map>

namespace glissade {
namespace {

/// Units that are conversions of conversions end here.
constexpr int kDeepestUnit = 8;
constexpr double kMillimetresPerMetre = 1000.0;

double factorOf(StepBasic_SiPrefix prefix) {
  switch (prefix) {
    case StepBasic_spKilo: return 1e3;
    case StepBasic_spDeci: return 1e-1;
    case StepBasic_spCenti: return 1e-2;
    case StepBasic_spMilli: return 1e-3;
    case StepBasic_spMicro: return 1e-6;
    default: return 0.0;
  }
}

std::optional<double> millimetresIn(const Handle(StepBasic_NamedUnit) & unit, int depth = 0) {
  if (const auto si = Handle(StepBasic_SiUnit)::DownCast(unit); !si.IsNull()) {
    if (si->Name() != StepBasic_sunMetre) return std::nullopt;
    const double factor = si->HasPrefix() ? factorOf(si->Prefix()) : 1.0;
    return factor > 0.0 ? std::optional(kMillimetresPerMetre * factor) : std::nullopt;
  }
  const auto converted = Handle(StepBasic_ConversionBasedUnit)::DownCast(unit);
  if (converted.IsNull() || converted->ConversionFactor().IsNull() || depth == kDeepestUnit) return std::nullopt;
  const Handle(StepBasic_MeasureWithUnit) factor = converted->ConversionFactor();
  const auto base = millimetresIn(factor->UnitComponent().NamedUnit(), depth + 1);
  return base ? std::optional(*base * factor->ValueComponent()) : std::nullopt;
}

/// Of a unit of area or volume that is made of a unit of length: how many square or cubic millimetres.
std::optional<double> unitOf(const Handle(StepBasic_MeasureWithUnit) & measure, int dimension) {
  const Handle(StepBasic_DerivedUnit) unit = measure->UnitComponent().DerivedUnit();
  if (unit.IsNull()) return std::nullopt;
  double factor = 1.0;
  double exponents = 0.0;
  for (int i = 1; i <= unit->NbElements(); ++i) {
    const Handle(StepBasic_DerivedUnitElement) element = unit->ElementsValue(i);
    const auto length = millimetresIn(element->Unit());
    if (!length) return std::nullopt;
    factor *= std::pow(*length, element->Exponent());
    exponents += element->Exponent();
  }
  return exponents == dimension ? std::optional(factor) : std::nullopt;
}

void takeMeasure(const STEPConstruct_ValidationProps& properties,
                 const Handle(StepRepr_MeasureRepresentationItem) & item, StatedMeasures& stated) {
  double value = 0.0;
  bool isArea = false;
  if (!properties.GetPropReal(item, value, isArea)) return;
  const auto unit = unitOf(item->Measure(), isArea ? 2 : 3);
  if (!unit || !std::isfinite(value * *unit)) return;
  (isArea ? stated.area : stated.volume) = value * *unit;
}

void take(const STEPConstruct_ValidationProps& properties, const Handle(StepRepr_Representation) & representation,
          StatedMeasures& stated) {
  for (int i = 1; i <= representation->NbItems(); ++i) {
    const Handle(StepRepr_RepresentationItem) item = representation->ItemsValue(i);
    if (const auto measure = Handle(StepRepr_MeasureRepresentationItem)::DownCast(item); !measure.IsNull()) {
      takeMeasure(properties, measure, stated);
    }
    gp_Pnt point;
    if (!item.IsNull() && item->IsKind(STANDARD_TYPE(StepGeom_CartesianPoint)) &&
        properties.GetPropPnt(item, representation->ContextOfItems(), point)) {
      stated.centroid = point;
    }
  }
}

/// Named "geometric validation property", with blanks or without.
bool isValidation(const Handle(StepRepr_PropertyDefinition) & definition) {
  if (definition.IsNull() || definition->Name().IsNull()) return false;
  const std::string name = definition->Name()->ToCString();
  return name.find("geometric") != std::string::npos && name.find("validation") != std::string::npos;
}

}  // namespace

std::vector<StatedMeasures> statedMeasuresOf(const STEPCAFControl_Reader& reader) {
  const Handle(XSControl_WorkSession) session = reader.Reader().WS();
  const auto model = Handle(StepData_StepModel)::DownCast(session->Model());
  const STEPConstruct_ValidationProps properties(session);
  TColStd_SequenceOfTransient found;
  std::vector<StatedMeasures> measures;
  if (!properties.LoadProps(found)) return measures;
  std::map<const TopoDS_TShape*, std::size_t> indexOf;
  for (const Handle(Standard_Transient) & each : found) {
    const auto property = Handle(StepRepr_PropertyDefinitionRepresentation)::DownCast(each);
    if (property.IsNull() || property->UsedRepresentation().IsNull()) continue;
    const Handle(StepRepr_PropertyDefinition) definition = property->Definition().PropertyDefinition();
    if (!isValidation(definition) || !properties.GetPropNAUO(definition).IsNull()) continue;
    const TopoDS_Shape shape = properties.GetPropShape(definition);
    if (shape.IsNull()) continue;
    const auto [at, isNew] = indexOf.try_emplace(shape.TShape().get(), measures.size());
    if (isNew) measures.push_back({"#" + std::to_string(model->IdentLabel(each)), shape});
    take(properties, property->UsedRepresentation(), measures[at->second]);
  }
  return measures;
}

}  // namespace glissade
