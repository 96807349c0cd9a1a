#include "widgets/document/workbench_document.h"

#include <QScopedValueRollback>
#include <QUndoCommand>

#include <utility>

#include "engine/base/file.h"
#include "engine/files/asset_path.h"
#include "engine/files/forbidden_places_of.h"
#include "engine/files/same_problem.h"
#include "engine/files/scenario_io.h"
#include "widgets/controls/body_id_text.h"
#include "widgets/document/value_command.h"

namespace glissade {

/// The scenario before and after an edit, as values, with the file that their assets are named relative to.
class ArrangementCommand final : public QUndoCommand {
 public:
  ArrangementCommand(WorkbenchDocument& document, const QString& text, Scenario after, ScenarioPtr loaded,
                     QString mergeKey)
      : QUndoCommand(text),
        document_(document),
        file_(loaded->file),
        before_(document.current()),
        after_(std::move(after)),
        loaded_(std::move(loaded)),
        temporary_(document.isTemporary()),
        mergeKey_(std::move(mergeKey)) {}

  void undo() override {
    document_.applyArrangement(before_, file_);
    setObsolete(temporary_);
  }
  void redo() override {
    if (const ScenarioPtr loaded = std::move(loaded_)) {
      document_.takeArrangement(loaded);
    } else {
      document_.applyArrangement(after_, file_);
    }
  }
  /// The scenario after redo() (`forth`) or undo().
  const Scenario& assembly(bool forth) const { return forth ? after_ : before_; }
  const std::string& file() const { return file_; }
  int id() const override { return mergeKey_.isEmpty() ? -1 : 2; }
  bool mergeWith(const QUndoCommand* next) override {
    const auto& other = static_cast<const ArrangementCommand&>(*next);
    if (other.mergeKey_ != mergeKey_ || other.file_ != file_) return false;
    after_ = other.after_;
    return true;
  }

 private:
  WorkbenchDocument& document_;
  std::string file_;
  Scenario before_;
  Scenario after_;
  ScenarioPtr loaded_;  ///< null once the command was done for the first time
  bool temporary_;
  QString mergeKey_;
};

WorkbenchDocument::WorkbenchDocument(QObject* parent)
    : QObject(parent),
      semantics_(undo_),
      paths_(undo_),
      queue_([this] { return version_; }, [this] { return loader(); }, this) {
  connect(&queue_, &ArrangementQueue::failed, this, &WorkbenchDocument::editFailed);
  connect(&undo_, &QUndoStack::cleanChanged, this, [this] { announce(Change::File); });
  connect(&undo_, &QUndoStack::indexChanged, this, &WorkbenchDocument::followUndo);
  connect(&paths_, &PathShelf::changed, this, [this] {
    noteUnkept();
    announce(Change::Paths);
  });
  connect(&semantics_, &SemanticDocument::changed, this, [this] {
    if (semantics_.heldEdits() == *edits_) return;
    edits_ = std::make_shared<const SemanticEdits>(semantics_.heldEdits());
    announce(Change::Semantics);
  });
}

WorkbenchDocument::~WorkbenchDocument() {
  // Disconnects the undo stack, which signals its own end when its observers may be destroyed.
  undo_.disconnect();
}

void WorkbenchDocument::announce(Changes what) {
  pending_ |= what;
  constexpr auto kBasis = Change::Scenario | Change::Arrangement | Change::Semantics | Change::File;
  if (what & (kBasis | Change::Sequence | Change::Joints)) ++version_;
  if (announcing_ || collecting_ || !scenario_) return;
  const QScopedValueRollback<bool> announcing(announcing_, true);
  while (pending_) {
    const Changes now = std::exchange(pending_, Changes());
    emit changedForView(now);
    emit changedForSession(now);
    emit changed(now);
  }
}

void WorkbenchDocument::changeInOneRound(const std::function<void()>& change) {
  {
    const QScopedValueRollback<bool> collecting(collecting_, true);
    change();
  }
  announce({});
}

void WorkbenchDocument::open(const ScenarioPtr& scenario) {
  queue_.cancel();
  changeInOneRound([&] {
    scenario_ = scenario;
    geometry_ = scenario->geometry;
    savedProblem_ = scenario->file.empty() ? std::string() : scenario->problemSha256;
    options_ = scenario->scenario.environment;
    settings_ = {scenario->scenario.planner, scenario->scenario.seed, scenario->parameters};
    results_ = {};
    demands_ = scenario->scenario.sequence;
    plan_ = scenario->scenario.plan;
    unkept_ = false;
    aside_.reset();
    undo_.clear();
    undo_.setClean();  // setClean() has no effect on an empty stack that was not clean
    paths_.open(scenario->scenario.paths);
    semantics_.open(*scenario);
    announce(Changes(kEveryChange));
  });
  if (!queue_.isAtOnce()) finishOpening();
}

/// Finds the fits of the present scenario and prepares its world.
void WorkbenchDocument::finishOpening() {
  const auto isFinished = [this] { return !scenario_->fitsPending && scenario_->problem.world->isPrepared(); };
  if (isFinished()) return;
  ArrangementQueue::Job job;
  job.isEdit = false;
  job.begin = [this, isFinished]() -> Result<std::optional<Scenario>> {
    return isFinished() ? std::optional<Scenario>() : scenario_->scenario;
  };
  job.end = [this](const ScenarioPtr& loaded) {
    if (scenario_->fitsPending) takeArrangement(loaded);
  };
  if (const Outcome done = queue_.add(std::move(job)); !done) emit editFailed(done.error());
}

Scenario WorkbenchDocument::current() const {
  Scenario scenario = scenario_->scenario;
  scenario.sequence = demands_;  // attributes of parts are semantic edits, which are set next
  setSemanticEdits(semantics_.edits(), scenario);
  scenario.paths = paths_.paths();
  scenario.plan = plan_;
  return scenario;
}

/// The present scenario with this assembly, whose assets are named relative to `file`.
Scenario WorkbenchDocument::assembled(const Scenario& assembly, const std::string& file) const {
  Scenario scenario = scenario_->scenario;
  takeAssembly(movedTo(scenario_->file, assembly, file), scenario);
  return scenario;
}

/// Returns a loader that reuses the preparation of the open scenario.
ArrangementQueue::Load WorkbenchDocument::loader() const {
  return [before = scenario_, known = geometry_](Scenario scenario, const StopToken& stop) -> Result<ScenarioPtr> {
    const std::string& file = before->file;
    auto loaded = loadGeometry(std::move(scenario), folderOf(file), file, known, stop, before.get());
    if (!loaded) return loaded.error();
    return ScenarioPtr(std::make_shared<LoadedScenario>(std::move(*loaded)));
  };
}

Outcome WorkbenchDocument::edit(const QString& text, ScenarioChange change, const QString& mergeKey) {
  return addEdit(text, std::move(change), mergeKey, false);
}

Outcome WorkbenchDocument::editTemporarily(const QString& text, ScenarioChange change) {
  return addEdit(text, std::move(change), {}, true);
}

void WorkbenchDocument::endTemporary() {
  if (!aside_) return;
  for (int index = undo_.index(); index > aside_->index; --index) undo();
}

/// Notes that the undo stack has restored the scenario that was set aside.
void WorkbenchDocument::followUndo() {
  if (!aside_ || undo_.index() > aside_->index) return;
  const bool saved = aside_->saved;
  aside_.reset();
  if (saved) undo_.setClean();
  announce(Change::File);
}

Outcome WorkbenchDocument::addEdit(const QString& text, ScenarioChange change, const QString& mergeKey,
                                   bool temporary) {
  const auto after = std::make_shared<Scenario>();
  ArrangementQueue::Job job;
  job.mergeKey = mergeKey;
  job.begin = [this, after, change = std::move(change)]() -> Result<std::optional<Scenario>> {
    *after = current();
    const Outcome changed = change(*after);
    if (!changed) return changed.error();
    return std::optional<Scenario>(assembled(*after, scenario_->file));
  };
  job.end = [this, after, text, mergeKey, temporary](const ScenarioPtr& loaded) {
    addGeometry(loaded->geometry);
    if (temporary && !aside_) aside_ = SetAside{scenario_, current(), undo_.isClean(), undo_.index()};
    undo_.push(new ArrangementCommand(*this, text, std::move(*after), loaded, mergeKey));
  };
  return queue_.add(std::move(job));
}

/// Undoes or redoes a step of the undo stack. The scenario of an edit of the arrangement is loaded before.
void WorkbenchDocument::stepBack(bool forth) {
  const auto step = [this, forth] { forth ? undo_.redo() : undo_.undo(); };
  ArrangementQueue::Job job;
  job.begin = [this, forth, step]() -> Result<std::optional<Scenario>> {
    const QUndoCommand* next = undo_.command(forth ? undo_.index() : undo_.index() - 1);
    const auto* edit = dynamic_cast<const ArrangementCommand*>(next);
    if (edit != nullptr) return std::optional<Scenario>(assembled(edit->assembly(forth), edit->file()));
    step();
    return std::optional<Scenario>();
  };
  job.end = [this, step](const ScenarioPtr& loaded) {
    prepared_ = loaded;
    step();
    prepared_.reset();
  };
  if (const Outcome done = queue_.add(std::move(job)); !done) emit editFailed(done.error());
}

void WorkbenchDocument::whenArranged(const std::function<void()>& then) {
  if (scenario_ && scenario_->fitsPending && queue_.isEmpty()) finishOpening();
  ArrangementQueue::Job job;
  job.isEdit = false;
  job.begin = [this, then]() -> Result<std::optional<Scenario>> {
    if (!scenario_ || !scenario_->fitsPending) then();
    return std::optional<Scenario>();
  };
  (void)queue_.add(std::move(job));
}

void WorkbenchDocument::cancelEdits() {
  if (queue_.isEmpty()) return;
  queue_.cancel();
  emit editFailed(std::nullopt);
}

Outcome WorkbenchDocument::place(const AssemblyItem& item, const Pose& X_WB, const QString& mergeKey) {
  if (queue_.isEmpty() && poseOf(current(), item) == X_WB) return Done{};
  const QString text = tr("Move %1").arg(item.kind == AssemblyItem::Kind::Body    ? toQString(item.bodyId)
                                         : item.kind == AssemblyItem::Kind::Start ? tr("the start")
                                                                                  : tr("the goal"));
  return edit(
      text, [item, X_WB](Scenario& scenario) { return glissade::place(item, X_WB, scenario); }, mergeKey);
}

void WorkbenchDocument::takeArrangement(const ScenarioPtr& scenario) {
  changeInOneRound([&] {
    scenario_ = scenario;
    semantics_.rearrange(*scenario);
    announce(Change::Arrangement);
  });
}

void WorkbenchDocument::applyArrangement(const Scenario& assembly, const std::string& file) {
  const Result<ScenarioPtr> loaded = prepared_ ? prepared_ : loader()(assembled(assembly, file), {});
  if (loaded) {
    addGeometry((*loaded)->geometry);
    takeArrangement(*loaded);
  } else {
    emit editFailed(loaded.error());
  }
}

void WorkbenchDocument::setKnowledge(const SceneKnowledgePtr& knowledge) {
  if (knowledge != semantics_.knowledge()) semantics_.setKnowledge(knowledge);
  announce(Change::Knowledge);
}

void WorkbenchDocument::setOptions(const EnvironmentOptions& options) {
  if (options == options_) return;
  options_ = options;
  announce(Change::Options);
}

void WorkbenchDocument::setSettings(const RunSettings& settings) {
  if (settings == settings_) return;
  settings_ = settings;
  announce(Change::Settings);
}

void WorkbenchDocument::setResults(const RunResults& results) {
  if (results == results_) return;
  changeInOneRound([&] {
    results_ = results;
    noteUnkept();
    announce(Change::Results);
  });
}

void WorkbenchDocument::setDemands(const QString& text, const SequenceDemands& demands) {
  if (demands == demands_) return;
  const auto take = [this](const SequenceDemands& taken) { takeDemands(taken); };
  undo_.push(new ValueCommand<SequenceDemands>(text, demands_, demands, take));
}

void WorkbenchDocument::takeDemands(const SequenceDemands& demands) {
  demands_ = demands;
  announce(Change::Sequence);
}

void WorkbenchDocument::setJoints(const QString& text, const std::vector<JointEdit>& joints) {
  const std::vector<JointEdit>& before = scenario_->scenario.joints;
  if (joints == before) return;
  const auto take = [this](const std::vector<JointEdit>& taken) { takeJoints(taken); };
  auto* command = new ValueCommand<std::vector<JointEdit>>(text, before, joints, take);
  if (isTemporary()) command->doOnce();  // the temporary scenario lacks edits of joints of the parts that have left
  undo_.push(command);
}

void WorkbenchDocument::takeJoints(const std::vector<JointEdit>& joints) {
  auto scenario = std::make_shared<LoadedScenario>(*scenario_);
  scenario->scenario.joints = joints;
  scenario_ = std::move(scenario);
  announce(Change::Joints);
}

void WorkbenchDocument::setPlan(const std::shared_ptr<const AssemblyPlan>& plan) {
  const bool before = isModified();
  plan_ = plan;
  if (isModified() != before) announce(Change::File);
}

void WorkbenchDocument::noteUnkept() {
  const bool before = unkept_;
  const Path* path = results_.path.get();
  const bool ofARun = path != nullptr && !results_.provenance.planner.empty();
  unkept_ = ofARun && !isTemporary() && exported_.lock() != results_.path && !paths_.holds(path->points);
  if (unkept_ != before) announce(Change::File);
}

KeptPath WorkbenchDocument::resultAsKept() const {
  std::string name;
  for (int number = 1; name.empty() || paths_.find(name); ++number) name = tr("Path %1").arg(number).toStdString();
  return keptPath(name, *results_.path, results_.provenance, results_.smoothed, *scenario_);
}

void WorkbenchDocument::keepResult() {
  if (results_.path && !paths_.holds(results_.path->points)) paths_.keep(resultAsKept());
}

void WorkbenchDocument::noteExported(const std::shared_ptr<const Path>& path) {
  exported_ = path;
  noteUnkept();
}

Scenario WorkbenchDocument::contentFor(const std::string& file) const {
  Scenario scenario = movedTo(file, aside_ ? aside_->scenario : current(), scenario_->file);
  scenario.environment = options_;
  scenario.planner = settings_.strategy;
  scenario.seed = settings_.seed;
  for (const ParameterSpec& spec : parameterTable()) {
    const double value = settings_.parameters[spec.id];
    if (value != scenario_->parameters[spec.id]) scenario.parameters[spec.id] = value;
  }
  if (unkept_) scenario.paths.push_back(std::make_shared<const KeptPath>(resultAsKept()));
  scenario.forbiddenRegions.clear();  // they may have moved
  return scenario;
}

Scenario WorkbenchDocument::savedContentFor(const std::string& file) const {
  Scenario scenario = contentFor(file);
  // If an edit forbids a place that does not exist, the file states no regions, and the check of a path reports that.
  if (auto places = forbiddenPlacesOf(aside_ ? *aside_->loaded : *scenario_, scenario))
    scenario.forbiddenRegions = std::move(*places);
  return scenario;
}

void WorkbenchDocument::noteSaved(const std::string& file, const Scenario& content) {
  changeInOneRound([&] {
    auto saved = std::make_shared<LoadedScenario>(*scenario_);
    saved->scenario = content;
    saved->file = file;
    if (aside_) {
      takeAssembly(movedTo(file, scenario_->scenario, scenario_->file), saved->scenario);
      aside_->scenario = content;
      aside_->saved = true;
    } else {
      undo_.setClean();
    }
    saved->parameters = settings_.parameters;
    savedProblem_ = problemSha256(content);
    saved->problemSha256 = problemSha256(saved->scenario);
    scenario_ = std::move(saved);
    announce(Change::File);
  });
}

bool WorkbenchDocument::isModified() const { return hasUnsavedEdits() || hasUnsavedPlan(); }

bool WorkbenchDocument::hasUnsavedPlan() const { return scenario_ && plan_ != scenario_->scenario.plan; }

bool WorkbenchDocument::hasUnsavedEdits() const {
  const bool edited = aside_ ? !aside_->saved : queue_.hasEdits() || !undo_.isClean();
  return scenario_ &&
         (edited || options_ != scenario_->scenario.environment || settings_.strategy != scenario_->scenario.planner);
}

bool WorkbenchDocument::isProblemSaved() const { return scenario_->problemSha256 == savedProblem_; }

}  // namespace glissade
