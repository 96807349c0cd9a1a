#include "engine/import/step_face_entities.h"

#include <StepData_StepModel.hxx>
#include <StepShape_Face.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

namespace glissade {

FaceEntities::FaceEntities(const STEPCAFControl_Reader& reader) {
  const auto model = Handle(StepData_StepModel)::DownCast(reader.Reader().WS()->Model());
  const Handle(Transfer_TransientProcess) process = reader.Reader().WS()->TransferReader()->TransientProcess();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    if (!model->Value(i)->IsKind(STANDARD_TYPE(StepShape_Face))) continue;
    const TopoDS_Shape shape = TransferBRep::ShapeResult(process, model->Value(i));
    if (!shape.IsNull()) numbers_.emplace(shape.TShape().get(), model->IdentLabel(model->Value(i)));
  }
}

std::string FaceEntities::nameOf(const TopoDS_Face& face) const {
  const auto found = numbers_.find(face.TShape().get());
  return found == numbers_.end() || found->second == 0 ? "#?" : "#" + std::to_string(found->second);
}

}  // namespace glissade
