#include "app/window/assembly_controller.h"

#include <QLocale>
#include <QVBoxLayout>

#include "engine/planning/automatic/freeing.h"

namespace glissade {

AssemblyController::AssemblyController(SemanticDocument& semantics, const ActionCatalogue& actions, SceneWidget& scene,
                                       QWidget* window)
    : QObject(window),
      semantics_(semantics),
      actions_(actions),
      document_(semantics),
      tool_(scene, this),
      panel_(new QWidget(window)),
      scenePanel_(new ScenePanel(panel_)),
      placement_(new PlacementPanel(panel_)) {
  auto* column = new QVBoxLayout(panel_);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(scenePanel_, 1);
  column->addWidget(placement_);
  for (const char* id : {"assembly.moves", "assembly.remove", "body.hide", "body.isolate", "body.show-all"}) {
    scenePanel_->addAction(actions_[QLatin1String(id)]);
  }
  scenePanel_->setContextMenuPolicy(Qt::ActionsContextMenu);

  connect(&document_, &AssemblyDocument::failed, this, &AssemblyController::failed);
  connect(&semantics_, &SemanticDocument::selectionChanged, this, &AssemblyController::takeSelection);
  connect(scenePanel_, &ScenePanel::bodiesChosen, this, [this](const QSet<QString>& bodies) {
    SemanticSelection selection = semantics_.selection();
    selection.bodies = bodies;
    semantics_.select(selection);
  });
  connect(scenePanel_, &ScenePanel::endChosen, this, [this](AssemblyItem::Kind end) { choose(AssemblyItem{end, {}}); });
  connect(placement_, &PlacementPanel::placed, this, [this](const Pose& X_WB) {
    const QString key = QStringLiteral("place %1 %2").arg(static_cast<int>(chosen_->kind));
    carryOut(document_.place(*chosen_, X_WB, key.arg(QString::fromStdString(chosen_->bodyId))));
  });
  connect(&tool_, &ArrangeTool::gripped, this, &AssemblyController::choose);
  connect(&tool_, &ArrangeTool::dropped, this,
          [this](const AssemblyItem& item, const Pose& X_WB) { carryOut(document_.place(item, X_WB)); });
  connectActions();
  enableActions();
}

void AssemblyController::connectActions() {
  const auto on = [this](const char* id, auto handler) {
    connect(actions_[QLatin1String(id)], &QAction::triggered, this, handler);
  };
  on("assembly.add", [this] { emit addPartsWanted(); });
  on("assembly.remove", [this] { removeSelected(); });
  on("assembly.moves", [this] { markSelected(); });
  on("assembly.arrange", [this](bool arrange) { tool_.setOn(arrange); });
  on("assembly.start-here", [this] {
    carryOut(document_.place({AssemblyItem::Kind::Start, {}}, snapshot_->device.q_device));
  });
  on("assembly.goal-here", [this] {
    carryOut(document_.place({AssemblyItem::Kind::Goal, {}}, snapshot_->device.q_device));
  });
  on("assembly.goal-out", [this] {
    editScenario(tr("Goal out"), [](Scenario& scenario) {
      scenario.goal = GoalOut{};
      return Outcome(Done{});
    });
  });
  on("assembly.fit-workspace", [this] {
    editScenario(tr("Fit the workspace"), [this](Scenario& scenario) {
      scenario.workspace = fittingWorkspace(*document_.scenario());
      return Outcome(Done{});
    });
  });
  on("assembly.free-ends", [this] { freeEnds(); });
  on("assembly.swap", [this] { editScenario(tr("Swap start and goal"), swapEnds); });
}

void AssemblyController::show(const ScenarioPtr& scenario) {
  if (document_.scenario() != scenario) document_.open(scenario);
  tool_.setScenario(scenario);
  scenePanel_->setScenario(*scenario);
  if (chosen_ && !poseOf(scenario->scenario, *chosen_)) chosen_.reset();
  takeSelection();
}

void AssemblyController::setState(bool editable, const SnapshotPtr& snapshot) {
  snapshot_ = snapshot;
  if (editable == editable_) return;
  editable_ = editable;
  if (!editable) actions_[QStringLiteral("assembly.arrange")]->setChecked(false);
  tool_.setOn(actions_[QStringLiteral("assembly.arrange")]->isChecked());
  showPlacement();
  enableActions();
}

void AssemblyController::carryOut(const Outcome& outcome) {
  if (!outcome) emit failed(outcome.error());
}

void AssemblyController::editScenario(const QString& text, const std::function<Outcome(Scenario&)>& change) {
  Scenario after = document_.current();
  const Outcome changed = change(after);
  carryOut(changed ? document_.edit(text, std::move(after)) : changed);
}

/// Ids of the scenario's bodies, the object not among them.
std::set<std::string> AssemblyController::selectedBodies() const {
  std::set<std::string> ids;
  for (const QString& id : semantics_.selection().bodies) ids.insert(bodyIdOf(id.toStdString()));
  if (document_.scenario()) ids.erase(document_.scenario()->scenario.object.id);
  return ids;
}

void AssemblyController::removeSelected() {
  const std::set<std::string> ids = selectedBodies();
  const QString text =
      ids.size() == 1 ? tr("Remove %1").arg(QString::fromStdString(*ids.begin())) : tr("Remove bodies");
  editScenario(text, [&](Scenario& scenario) {
    for (const std::string& id : ids) {
      const Outcome removed = removeBody(id, scenario);
      if (!removed) return removed;
    }
    return Outcome(Done{});
  });
}

void AssemblyController::markSelected() {
  const std::string id = *selectedBodies().begin();
  editScenario(tr("%1 moves").arg(QString::fromStdString(id)),
               [&](Scenario& scenario) { return markMoving(id, *document_.scenario(), scenario); });
}

void AssemblyController::freeEnds() {
  const LoadedScenario& loaded = *document_.scenario();
  const double required = snapshot_->parameters[ParameterId::RequiredClearance];
  Scenario after = document_.current();
  QStringList moved;
  for (const AssemblyItem::Kind end : {AssemblyItem::Kind::Start, AssemblyItem::Kind::Goal}) {
    const AssemblyItem item{end, {}};
    const auto before = poseOf(after, item);
    if (!before) continue;
    const auto clear = freed(loaded.problem.world, *before, required);
    if (!clear) {
      Diagnostic why = clear.error();
      why.place = end == AssemblyItem::Kind::Start ? "start" : "goal";
      emit failed(why);
      return;
    }
    if (*clear == *before) continue;
    (void)place(item, *clear, after);
    const QString by = QLocale().toString(1000.0 * (clear->position - before->position).norm(), 'f', 3);
    moved << (end == AssemblyItem::Kind::Start ? tr("the start went %1 mm").arg(by)
                                               : tr("the goal went %1 mm").arg(by));
  }
  if (moved.isEmpty()) {
    emit told(tr("Start and goal are clear of all bodies."));
    return;
  }
  carryOut(document_.edit(tr("Clear start and goal"), std::move(after)));
  emit told(tr("Clear of all bodies: %1").arg(moved.join(QStringLiteral(", "))));
}

void AssemblyController::choose(const std::optional<AssemblyItem>& item) {
  SemanticSelection selection = semantics_.selection();
  selection.bodies.clear();
  for (const RigidBody& body : document_.scenario()->obstacles) {
    if (item && item->kind == AssemblyItem::Kind::Body && bodyIdOf(body.id) == item->bodyId) {
      selection.bodies.insert(QString::fromStdString(body.id));
    }
  }
  chosen_ = item;
  semantics_.select(selection);
  takeSelection();
}

/// One body that is selected is what is placed; the object is placed at its start.
void AssemblyController::takeSelection() {
  if (!document_.scenario()) return;
  const std::set<std::string> ids = selectedBodies();
  const bool object =
      semantics_.selection().bodies.contains(QString::fromStdString(document_.scenario()->scenario.object.id));
  const bool endChosen = chosen_ && chosen_->kind != AssemblyItem::Kind::Body;
  if (ids.size() == 1 && !object) {
    chosen_ = AssemblyItem{AssemblyItem::Kind::Body, *ids.begin()};
  } else if (ids.empty() && object) {
    chosen_ = AssemblyItem{AssemblyItem::Kind::Start, {}};
  } else if (!ids.empty() || !endChosen) {
    chosen_.reset();
  }
  tool_.setSelected(chosen_);
  scenePanel_->showSelection(semantics_.selection().bodies, chosen_);
  showPlacement();
  enableActions();
}

void AssemblyController::showPlacement() {
  if (!document_.scenario()) return;
  QString name;
  if (chosen_ && chosen_->kind == AssemblyItem::Kind::Start) name = tr("the start");
  if (chosen_ && chosen_->kind == AssemblyItem::Kind::Goal) name = tr("the goal");
  if (chosen_ && chosen_->kind == AssemblyItem::Kind::Body) name = QString::fromStdString(chosen_->bodyId);
  const auto pose = chosen_ ? poseOf(document_.scenario()->scenario, *chosen_) : std::nullopt;
  placement_->show(name, pose);
  placement_->setEnabled(editable_);
}

void AssemblyController::enableActions() {
  const auto enable = [this](const char* id, bool enabled) { actions_[QLatin1String(id)]->setEnabled(enabled); };
  const std::size_t bodies = selectedBodies().size();
  const bool goal = document_.scenario() && std::holds_alternative<Pose>(document_.scenario()->scenario.goal);
  enable("assembly.add", editable_);
  enable("assembly.remove", editable_ && bodies > 0);
  enable("assembly.moves", editable_ && bodies == 1);
  enable("assembly.arrange", editable_);
  enable("assembly.fit-workspace", editable_);
  enable("assembly.free-ends", editable_);
  enable("assembly.start-here", editable_);
  enable("assembly.goal-here", editable_);
  enable("assembly.goal-out", editable_ && goal);
  enable("assembly.swap", editable_ && goal);
}

}  // namespace glissade
