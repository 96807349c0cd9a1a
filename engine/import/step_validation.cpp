#include "engine/import/step_validation.h"

#include <STEPConstruct_ValidationProps.hxx>
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

void takeMeasure(const STEPConstruct_ValidationProps& properties,
                 const Handle(StepRepr_MeasureRepresentationItem) & item, StatedMeasures& stated) {
  double value = 0.0;
  bool isArea = false;
  if (!properties.GetPropReal(item, value, isArea) || !std::isfinite(value)) return;  // in millimetres
  (isArea ? stated.area : stated.volume) = value;
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

/// True if it is named "geometric validation property", with or without blanks.
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
