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

namespace glissade {
namespace {

/// More lines than that are one line that counts them.
constexpr std::size_t kMostLines = 20;

class LossSearch {
 public:
  explicit LossSearch(const STEPCAFControl_Reader& reader)
      : model_(reader.Reader().WS()->Model()), process_(reader.Reader().WS()->TransferReader()->TransientProcess()) {}

  std::vector<std::string> run() {
    for (int i = 1; i <= model_->NbEntities(); ++i) look(model_->Value(i));
    if (lost_ > kMostLines) lines_.push_back("\tand " + std::to_string(lost_ - kMostLines) + " more");
    return std::move(lines_);
  }

 private:
  void look(const Handle(Standard_Transient) & entity) {
    if (const auto shell = Handle(StepShape_ConnectedFaceSet)::DownCast(entity); !shell.IsNull()) {
      lookAtShell(shell);
    } else if (const auto face = Handle(StepShape_Face)::DownCast(entity); !face.IsNull() && isMade(face)) {
      lookAtFace(face);
    } else if (const auto solid = Handle(StepShape_ManifoldSolidBrep)::DownCast(entity);
               !solid.IsNull() && !isMade(solid)) {
      note(solid, "the solid could not be made");
    }
  }

  void lookAtShell(const Handle(StepShape_ConnectedFaceSet) & shell) {
    for (int i = 1; i <= shell->NbCfsFaces(); ++i) {
      const Handle(StepShape_Face) face = shell->CfsFacesValue(i);
      if (face.IsNull()) {
        note(shell, "number " + std::to_string(i) + " of its faces is no face");
      } else if (!isMade(face)) {
        note(shell, "its face " + nameOf(face) + " could not be made");
      }
    }
  }

  void lookAtFace(const Handle(StepShape_Face) & face) {
    for (int i = 1; i <= face->NbBounds(); ++i) {
      const Handle(StepShape_FaceBound) bound = face->BoundsValue(i);
      const Handle(StepShape_Loop) loop = bound.IsNull() ? nullptr : bound->Bound();
      if (!loop.IsNull() && (loop->IsKind(STANDARD_TYPE(StepShape_VertexLoop)) || isMade(loop))) continue;
      note(face, "number " + std::to_string(i) + " of its boundaries could not be made");
    }
  }

  bool isMade(const Handle(Standard_Transient) & entity) const {
    return !TransferBRep::ShapeResult(process_, entity).IsNull();
  }

  /// "#12", as the file calls it.
  std::string nameOf(const Handle(Standard_Transient) & entity) const {
    return model_->StringLabel(entity)->ToCString();
  }

  void note(const Handle(Standard_Transient) & entity, const std::string& what) {
    if (++lost_ <= kMostLines) lines_.push_back(nameOf(entity) + "\t" + what);
  }

  Handle(Interface_InterfaceModel) model_;
  Handle(Transfer_TransientProcess) process_;
  std::vector<std::string> lines_;
  std::size_t lost_ = 0;
};

}  // namespace

std::vector<std::string> lossesOf(const STEPCAFControl_Reader& reader) { return LossSearch(reader).run(); }

}  // namespace glissade
