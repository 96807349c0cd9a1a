#include "engine/import/step_losses.h"

#include <Interface_InterfaceModel.hxx>
#include <StepShape_ConnectedFaceSet.hxx>
#include <StepShape_Face.hxx>
#include <StepShape_FaceBound.hxx>
#include <StepShape_Loop.hxx>
#include <StepShape_ManifoldSolidBrep.hxx>
#include <StepShape_VertexLoop.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include "engine/import/import_refusal.h"

namespace glissade {
namespace {

constexpr std::size_t kMostLosses = 1'000;

class LossSearch {
 public:
  explicit LossSearch(const STEPCAFControl_Reader& reader)
      : model_(reader.Reader().WS()->Model()), process_(reader.Reader().WS()->TransferReader()->TransientProcess()) {}

  std::vector<StepLoss> run() {
    for (int i = 1; i <= model_->NbEntities(); ++i) look(model_->Value(i));
    return std::move(losses_);
  }

 private:
  void look(const Handle(Standard_Transient) & entity) {
    if (const auto shell = Handle(StepShape_ConnectedFaceSet)::DownCast(entity); !shell.IsNull()) {
      lookAtShell(shell);
    } else if (const auto face = Handle(StepShape_Face)::DownCast(entity); !face.IsNull() && isMade(face)) {
      lookAtFace(face);
    } else if (const auto solid = Handle(StepShape_ManifoldSolidBrep)::DownCast(entity);
               !solid.IsNull() && !isMade(solid)) {
      note(solid, GLISSADE_TEXT("the solid could not be made"), {});
    }
  }

  void lookAtShell(const Handle(StepShape_ConnectedFaceSet) & shell) {
    for (int i = 1; i <= shell->NbCfsFaces(); ++i) {
      const Handle(StepShape_Face) face = shell->CfsFacesValue(i);
      if (face.IsNull()) {
        note(shell, {GLISSADE_TEXT("number %1 of its faces is not a face"), {i}}, faceOf(shell));
      } else if (!isMade(face)) {
        note(shell, {GLISSADE_TEXT("its face %1 could not be made"), {nameOf(face)}}, faceOf(shell));
      }
    }
  }

  void lookAtFace(const Handle(StepShape_Face) & face) {
    for (int i = 1; i <= face->NbBounds(); ++i) {
      const Handle(StepShape_FaceBound) bound = face->BoundsValue(i);
      const Handle(StepShape_Loop) loop = bound.IsNull() ? nullptr : bound->Bound();
      if (!loop.IsNull() && (loop->IsKind(STANDARD_TYPE(StepShape_VertexLoop)) || isMade(loop))) continue;
      note(face, {GLISSADE_TEXT("number %1 of its boundaries could not be made"), {i}},
           TransferBRep::ShapeResult(process_, face));
    }
  }

  /// The first face that was made.
  TopoDS_Shape faceOf(const Handle(StepShape_ConnectedFaceSet) & shell) const {
    for (int i = 1; i <= shell->NbCfsFaces(); ++i) {
      const Handle(StepShape_Face) face = shell->CfsFacesValue(i);
      if (!face.IsNull() && isMade(face)) return TransferBRep::ShapeResult(process_, face);
    }
    return {};
  }

  bool isMade(const Handle(Standard_Transient) & entity) const {
    return !TransferBRep::ShapeResult(process_, entity).IsNull();
  }

  /// "#12": the name of the entity in the file.
  std::string nameOf(const Handle(Standard_Transient) & entity) const {
    return model_->StringLabel(entity)->ToCString();
  }

  void note(const Handle(Standard_Transient) & entity, const Message& what, const TopoDS_Shape& face) {
    if (losses_.size() == kMostLosses) {
      throw ImportRefusal{{GLISSADE_TEXT("more than %1 of its faces could not be made"), {kMostLosses}}};
    }
    losses_.push_back({nameOf(entity), what, face});
  }

  Handle(Interface_InterfaceModel) model_;
  Handle(Transfer_TransientProcess) process_;
  std::vector<StepLoss> losses_;
};

}  // namespace

std::vector<StepLoss> lossesOf(const STEPCAFControl_Reader& reader) { return LossSearch(reader).run(); }

}  // namespace glissade
