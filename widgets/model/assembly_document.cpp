#include "widgets/model/assembly_document.h"

#include <QUndoCommand>

#include "engine/base/file.h"
#include "engine/scenario/asset_path.h"
#include "engine/scenario/run_record.h"
#include "engine/scenario/scenario_io.h"

namespace glissade {

using LoadedScenarioPtr = std::shared_ptr<const LoadedScenario>;

/// The scenario before and after, as values, with the file that their assets are named from.
class ChangeAssembly final : public QUndoCommand {
 public:
  ChangeAssembly(AssemblyDocument& document, const QString& text, Scenario after, LoadedScenarioPtr realised,
                 QString mergeKey)
      : QUndoCommand(text),
        document_(document),
        file_(realised->file),
        before_(document.current()),
        after_(std::move(after)),
        realised_(std::move(realised)),
        mergeKey_(std::move(mergeKey)) {}

  void undo() override { document_.apply(before_, file_); }
  void redo() override {
    if (const LoadedScenarioPtr realised = std::move(realised_)) {
      document_.take(realised);
    } else {
      document_.apply(after_, file_);
    }
  }
  int id() const override { return mergeKey_.isEmpty() ? -1 : 2; }
  bool mergeWith(const QUndoCommand* next) override {
    const auto& other = static_cast<const ChangeAssembly&>(*next);
    if (other.mergeKey_ != mergeKey_ || other.file_ != file_) return false;
    after_ = other.after_;
    return true;
  }

 private:
  AssemblyDocument& document_;
  std::string file_;
  Scenario before_;
  Scenario after_;
  LoadedScenarioPtr realised_;  ///< until it is done for the first time
  QString mergeKey_;
};

AssemblyDocument::AssemblyDocument(SemanticDocument& semantics, QObject* parent)
    : QObject(parent), semantics_(semantics) {}

void AssemblyDocument::open(const LoadedScenarioPtr& scenario) {
  scenario_ = scenario;
  read_ = scenario->geometry;
  savedProblem_ = scenario->file.empty() ? std::string() : problemSha256(scenario->scenario);
}

bool AssemblyDocument::isSaved() const { return problemSha256(scenario_->scenario) == savedProblem_; }

Scenario AssemblyDocument::current() const {
  Scenario scenario = scenario_->scenario;
  setSemanticEdits(semantics_.edits(), scenario);
  return scenario;
}

/// `assembly` in the scenario of today, its assets named from `file`.
Result<LoadedScenarioPtr> AssemblyDocument::realise(const Scenario& assembly, const std::string& file) {
  Scenario scenario = scenario_->scenario;
  takeAssembly(movedTo(scenario_->file, assembly, file), scenario);
  auto loaded = realiseScenario(std::move(scenario), folderOf(scenario_->file), scenario_->file, read_);
  if (!loaded) return loaded.error();
  read_.insert(loaded->geometry.begin(), loaded->geometry.end());
  return LoadedScenarioPtr(std::make_shared<LoadedScenario>(std::move(*loaded)));
}

Outcome AssemblyDocument::edit(const QString& text, Scenario after, const QString& mergeKey) {
  auto realised = realise(after, scenario_->file);
  if (!realised) return realised.error();
  semantics_.undoStack().push(new ChangeAssembly(*this, text, std::move(after), std::move(*realised), mergeKey));
  return Done{};
}

Outcome AssemblyDocument::place(const AssemblyItem& item, const Pose& X_WB, const QString& mergeKey) {
  Scenario after = current();
  if (poseOf(after, item) == X_WB) return Done{};
  const Outcome placed = glissade::place(item, X_WB, after);
  if (!placed) return placed;
  return edit(tr("Move %1").arg(item.kind == AssemblyItem::Kind::Body    ? QString::fromStdString(item.bodyId)
                                : item.kind == AssemblyItem::Kind::Start ? tr("the start")
                                                                         : tr("the goal")),
              std::move(after), mergeKey);
}

void AssemblyDocument::take(const LoadedScenarioPtr& scenario) {
  scenario_ = scenario;
  semantics_.rearrange(scenario);
  emit rearranged(scenario);
}

void AssemblyDocument::apply(const Scenario& assembly, const std::string& file) {
  const auto realised = realise(assembly, file);
  if (realised) {
    take(*realised);
  } else {
    emit failed(realised.error());
  }
}

}  // namespace glissade
