#include "widgets/product/assembly_controller.h"

#include <QLineEdit>
#include <QLocale>
#include <QShortcut>
#include <QVBoxLayout>

#include <algorithm>
#include <sstream>

#include "engine/base/number_text.h"
#include "engine/files/scenario_bodies.h"
#include "widgets/controls/body_id_text.h"
#include "widgets/controls/length_text.h"
#include "widgets/product/end_clearance.h"
#include "widgets/workbench/arranged_item.h"
#include "widgets/workbench/workbench.h"

namespace glissade {
namespace {

constexpr double kMillimetres = 1000.0;

constexpr double kDegreesInRadian = 180.0 / 3.14159265358979323846;

/// The smallest difference that the placement panel shows.
constexpr double kSame = 0.01;

using Words = ScriptCommands::Words;

Diagnostic noScenario() { return wrongCommand("no scenario is open", "Open one first."); }

AssemblyItem itemOf(const std::string& what) {
  if (what == "start") return {AssemblyItem::Kind::Start, {}};
  if (what == "goal") return {AssemblyItem::Kind::Goal, {}};
  return {AssemblyItem::Kind::Body, BodyId(what)};
}

/// "1,2.5,-3"
Result<Vector3> numbersOf(const std::string& text) {
  std::istringstream words(text);
  Vector3 numbers = Vector3::Zero();
  std::string word;
  int count = 0;
  for (; std::getline(words, word, ','); ++count) {
    const auto number = toNumber(word);
    if (!number || count == 3) break;
    numbers[count] = *number;
  }
  if (count == 3 && words.eof()) return numbers;
  return wrongCommand("'" + text + "' is not three numbers", "Give them with commas and no blanks.");
}

/// `words`: file, unit, up.
Outcome takePart(PartImport& parts, PartsDialog::Purpose purpose, PartRole role, const Words& words) {
  const auto unit = toNumber(words[1]);
  if (!unit) return wrongCommand("'" + words[1] + "' is not a unit", "Give metres.");
  Outcome outcome = Done{};
  const auto refused =
      QObject::connect(&parts, &PartImport::importFailed, [&outcome](const Diagnostic& why) { outcome = why; });
  PartFile part = usualPart(words[0]);
  part.role = role;
  part.unit = *unit;
  part.up = words[2] == "Y" ? UpAxis::Y : UpAxis::Z;
  parts.take(purpose, {part});
  QObject::disconnect(refused);
  return outcome;
}

Outcome setRule(WorkbenchDocument& document, const std::string& which, const std::string& expression) {
  if (!document.scenario()) return noScenario();
  StrategyRules rules = document.scenario()->scenario.rules.value_or(presetRules("gts"));
  (which == "node" ? rules.node : rules.edge) = expression;
  const auto& table = document.semantics().table();
  const auto parsed = parseRules(rules, table, idsOf(makeLocalPlannerRegistry()));
  if (!parsed) return parsed.error();
  return document.edit(QStringLiteral("rule"), [rules](Scenario& scenario) {
    scenario.rules = rules;
    return Outcome(Done{});
  });
}

Outcome place(WorkbenchDocument& document, const std::string& what, const std::string& position,
              const std::string& turn) {
  if (!document.scenario()) return noScenario();
  const auto millimetres = numbersOf(position);
  if (!millimetres) return millimetres.error();
  const auto degrees = numbersOf(turn);
  if (!degrees) return degrees.error();
  const Vector3 angles = *degrees / kDegreesInRadian;
  const Pose X_WB{*millimetres / kMillimetres, fromRollPitchYaw(angles.x(), angles.y(), angles.z())};
  return document.place(itemOf(what), X_WB);
}

Outcome expectPlace(WorkbenchDocument& document, const std::string& what, const std::string& position) {
  if (!document.scenario()) return noScenario();
  const Diagnostic elsewhere = unmetExpectation("'" + what + "' is not at " + position);
  const auto pose = poseOf(document.scenario()->scenario, itemOf(what));
  if (position == "nowhere" || !pose) {
    const bool met = position == "nowhere" && !pose;
    return met ? Outcome(Done{}) : elsewhere;
  }
  const auto millimetres = numbersOf(position);
  if (!millimetres) return millimetres.error();
  const double off = (kMillimetres * pose->position - *millimetres).cwiseAbs().maxCoeff();
  return off <= kSame ? Outcome(Done{}) : elsewhere;
}

/// Adds the script commands about parts, about the poses of parts and of the ends of the motion, and about rules.
void addAssemblyCommands(const Workbench& bench, PartImport& parts) {
  ScriptCommands& scripts = bench.scripts;
  WorkbenchDocument& document = bench.document;
  scripts.add("new-scenario", 3, [&parts](const Words& words) {
    return takePart(parts, PartsDialog::Purpose::NewScenario, PartRole::Moves, words);
  });
  scripts.add("add-part", 4, [&parts, &document](const Words& words) -> Outcome {
    if (!document.scenario()) return noScenario();
    const PartRole role = words[1] == "mobile" ? PartRole::Mobile : PartRole::Static;
    return takePart(parts, PartsDialog::Purpose::AddParts, role, {words[0], words[2], words[3]});
  });
  scripts.add("rule", 2, [&document](const Words& words) { return setRule(document, words[0], words[1]); });
  scripts.add("place", 3, [&document](const Words& words) { return place(document, words[0], words[1], words[2]); });
  scripts.add("expect-place", 2, [&document](const Words& words) { return expectPlace(document, words[0], words[1]); });
}

}  // namespace

AssemblyController::AssemblyController(const Workbench& bench, PartImport& parts)
    : QObject(&bench.window),
      bench_(bench),
      document_(bench.document),
      panel_(new QWidget(&bench.window)),
      scenePanel_(new ScenePanel(panel_)),
      placement_(new PlacementPanel(panel_)) {
  auto* column = new QVBoxLayout(panel_);
  column->setContentsMargins(0, 0, 0, 0);
  auto* search = new QLineEdit(panel_);
  search->setPlaceholderText(tr("Search bodies"));
  search->setAccessibleName(search->placeholderText());
  search->setClearButtonEnabled(true);
  connect(search, &QLineEdit::textChanged, scenePanel_, &ScenePanel::setFilter);
  column->addWidget(search);
  column->addWidget(scenePanel_, 1);
  column->addWidget(placement_);
  placement_->addPickAction(bench.actions["assembly.pick-frame"]);
  for (const char* id :
       {"body.rename", "body.properties", "assembly.moves", "assembly.remove", "assembly.leave-out",
        "assembly.put-back", "sequence.stays", "body.hide", "body.isolate", "body.show-all", "view.zoom-selection"}) {
    scenePanel_->addAction(bench.actions[QLatin1String(id)]);
  }
  scenePanel_->setContextMenuPolicy(Qt::ActionsContextMenu);
  // In the scene the key F chooses the axes of the hand.
  addKey(Qt::Key_H, "body.hide", scenePanel_);
  addKey(Qt::Key_H, "body.hide", bench.scene.widget());
  addKey(Qt::Key_F, "view.zoom-selection", scenePanel_);

  connect(&document_, &WorkbenchDocument::changed, this, &AssemblyController::followDocument);
  connect(&document_, &WorkbenchDocument::editFailed, this, [this](const std::optional<Diagnostic>& why) {
    if (why) showFailure(*why);
    followDocument(Change::Arrangement);
  });
  connect(&bench.run, &ShownRun::changed, this, &AssemblyController::followRun);
  connect(&document_.semantics(), &SemanticDocument::selectionChanged, this, &AssemblyController::takeSelection);
  connect(scenePanel_, &ScenePanel::bodiesChosen, this, [this](const QSet<QString>& bodies) {
    SemanticSelection selection = document_.semantics().selection();
    selection.bodies = bodies;
    document_.semantics().select(selection);
  });
  connect(scenePanel_, &ScenePanel::itemSelectionChanged, this, &AssemblyController::enableActions);
  connect(scenePanel_, &ScenePanel::bodyRenamed, this, [this](const QString& id, const QString& name) {
    editScenario(tr("Rename %1").arg(id), [id = toBodyId(id), name = name.toStdString()](Scenario& scenario) {
      return renameBody(id, name, scenario);
    });
  });
  connect(scenePanel_, &ScenePanel::lengthUnitChanged, this, [this] {
    if (document_.scenario()) followDocument(Change::Arrangement);
  });
  connect(scenePanel_, &ScenePanel::endChosen, this, [this](AssemblyItem::Kind end) { choose(AssemblyItem{end, {}}); });
  connect(placement_, &PlacementPanel::placed, this, [this](const Pose& X_WB) {
    const QString key = QStringLiteral("place %1 %2").arg(static_cast<int>(chosen_->kind));
    place(*chosen_, X_WB, key.arg(toQString(chosen_->bodyId)));
  });
  connect(placement_, &PlacementPanel::pointChosen, this, &AssemblyController::showPlacement);
  connectActions();
  enableActions();
  addAssemblyCommands(bench, parts);
  bench.scripts.add("choose-left-out", 1, [this](const ScriptCommands::Words& words) -> Outcome {
    if (scenePanel_->chooseLeftOut(BodyId(words[0]))) return Done{};
    return wrongCommand("'" + words[0] + "' is not left out");
  });
  bench.scripts.add("expect-placed-by", 1, [this](const ScriptCommands::Words& words) -> Outcome {
    const std::string about = placement_->chosenPoint().toStdString();
    if (about.find(words[0]) != std::string::npos) return Done{};
    return unmetExpectation("the placement is about '" + about + "', not '" + words[0] + "'");
  });
}

/// Lets a key carry out an action while the widget has the focus.
void AssemblyController::addKey(Qt::Key key, const char* action, QWidget* widget) {
  auto* shortcut = new QShortcut(QKeySequence(key), widget, nullptr, nullptr, Qt::WidgetShortcut);
  connect(shortcut, &QShortcut::activated, bench_.actions[action], &QAction::trigger);
}

void AssemblyController::connectActions() {
  const auto on = [this](const char* id, auto handler) { bench_.onAction(id, this, handler); };
  on("assembly.remove", [this] { removeSelected(); });
  on("assembly.leave-out", [this] { leaveOutSelected(); });
  on("assembly.put-back", [this] { putBackSelected(); });
  on("assembly.moves", [this] { markSelected(); });
  on("body.rename", [this] {
    bench_.actions["panel.scene"]->trigger();
    scenePanel_->editName();
  });
  on("body.properties", [this] { bench_.actions["panel.semantics"]->trigger(); });
  on("assembly.start-here", [this] {
    place({AssemblyItem::Kind::Start, {}}, bench_.session.snapshot()->device.q_device);
  });
  on("assembly.goal-here", [this] {
    place({AssemblyItem::Kind::Goal, {}}, bench_.session.snapshot()->device.q_device);
  });
  on("assembly.goal-out", [this] {
    editScenario(tr("Goal: removed"), [](Scenario& scenario) {
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
  on("assembly.free-ends", [this] { moveEndsClear(); });
  on("assembly.swap", [this] { editScenario(tr("Swap start and goal"), swapEnds); });
}

void AssemblyController::followDocument(Changes what) {
  if (!(what & (Change::Scenario | Change::Arrangement))) return;
  if (what & Change::Scenario) picked_.clear();
  scenePanel_->setScenario(*document_.scenario());
  if (chosen_ && !poseOf(document_.scenario()->scenario, *chosen_)) chosen_.reset();
  takeSelection();
}

void AssemblyController::followRun(const SnapshotPtr& snapshot) {
  const bool editable = bench_.run.isLive() && !isRunning(*snapshot);
  if (editable == editable_) return;
  editable_ = editable;
  showPlacement();
  enableActions();
  emit editableChanged(editable);
}

void AssemblyController::showFailure(const Outcome& outcome) {
  if (!outcome) bench_.messages.showError(tr("Not possible"), outcome.error());
}

void AssemblyController::place(const AssemblyItem& item, const Pose& X_WB, const QString& mergeKey) {
  showFailure(document_.place(item, X_WB, mergeKey));
}

void AssemblyController::editScenario(const QString& text, const std::function<Outcome(Scenario&)>& change) {
  showFailure(document_.edit(text, change));
}

/// Ids of the selected bodies of the scenario, including those of the object.
std::set<BodyId> AssemblyController::selectedOfAll() const {
  std::set<BodyId> ids;
  for (const QString& id : document_.semantics().selectedBodies()) ids.insert(bodyIdOf(toBodyId(id)));
  return ids;
}

/// Ids of the selected bodies, without those of the object.
std::set<BodyId> AssemblyController::selectedBodies() const {
  std::set<BodyId> ids = selectedOfAll();
  if (!document_.scenario()) return ids;
  for (const BodyDescription& body : document_.scenario()->scenario.object.bodies) ids.erase(body.id);
  return ids;
}

std::vector<BodyId> AssemblyController::selectedToMove() const {
  std::set<BodyId> ids = selectedOfAll();
  std::vector<BodyId> ordered;
  for (const BodyDescription& body : document_.scenario()->scenario.object.bodies) {
    if (ids.erase(body.id) > 0) ordered.push_back(body.id);
  }
  ordered.insert(ordered.end(), ids.begin(), ids.end());
  return ordered;
}

void AssemblyController::removeSelected() {
  const std::set<BodyId> ids = selectedBodies();
  editScenario(ids.size() == 1 ? tr("Remove %1").arg(toQString(*ids.begin())) : tr("Remove bodies"),
               [&ids](Scenario& scenario) { return editEach(ids, removeBody, scenario); });
}

void AssemblyController::leaveOutSelected() {
  const std::set<BodyId> ids = selectedBodies();
  editScenario(ids.size() == 1 ? tr("Exclude %1").arg(toQString(*ids.begin())) : tr("Exclude bodies"),
               [&ids](Scenario& scenario) { return editEach(ids, leaveOut, scenario); });
}

void AssemblyController::putBackSelected() {
  const std::vector<BodyId> ids = scenePanel_->chosenLeftOut();
  editScenario(tr("Include bodies"), [&ids](Scenario& scenario) { return editEach(ids, putBack, scenario); });
}

/// Marks the selected bodies as moving. Selected bodies of the object keep moving, so a group can grow.
void AssemblyController::markSelected() {
  const std::vector<BodyId> ids = selectedToMove();
  const QString first = toQString(ids.front());
  const QString text = ids.size() == 1
                           ? tr("Moving part: %1").arg(first)
                           : tr("Moving part: %1 and %n more", "", static_cast<int>(ids.size()) - 1).arg(first);
  editScenario(text, [&](Scenario& scenario) { return markMoving(ids, *document_.scenario(), scenario); });
}

/// Moves the ends clear in the background; an edit of the arrangement cancels it.
void AssemblyController::moveEndsClear() {
  const double required = document_.settings().parameters[ParameterId::RequiredClearance];
  bench_.work.run(
      tr("Resolving start and goal collisions"),
      [this, scenario = document_.scenario(), required](const WorkWatch& watch) -> BackgroundTask::Delivery {
        return [this, moved = endsMovedClear(*scenario, required, watch.stop)] { takeMovedEnds(moved); };
      });
}

void AssemblyController::takeMovedEnds(const Result<std::vector<MovedEnd>>& moved) {
  if (!moved) {
    showFailure(moved.error());
    return;
  }
  if (moved->empty()) {
    bench_.messages.showStatus(tr("Start and goal have no collisions."));
    return;
  }
  QStringList texts;
  for (const MovedEnd& end : *moved) {
    const QString by = lengthText(end.distance);
    texts << (end.item.kind == AssemblyItem::Kind::Start ? tr("the start was moved by %1").arg(by)
                                                         : tr("the goal was moved by %1").arg(by));
  }
  const auto change = [ends = *moved](Scenario& scenario) {
    for (const MovedEnd& end : ends) (void)glissade::place(end.item, end.X_WB, scenario);
    return Outcome(Done{});
  };
  const Outcome edited = document_.edit(tr("Resolve start and goal collisions"), change);
  showFailure(edited);
  if (edited) bench_.messages.showStatus(tr("Collisions resolved: %1").arg(texts.join(QStringLiteral(", "))));
}

void AssemblyController::choose(const std::optional<AssemblyItem>& item) {
  SemanticSelection selection = document_.semantics().selection();
  selection.bodies.clear();
  for (const RigidBody& body : document_.scenario()->obstacles) {
    if (item && item->kind == AssemblyItem::Kind::Body && bodyIdOf(body.id) == item->bodyId) {
      selection.bodies.insert(toQString(body.id));
    }
  }
  chosen_ = item;
  document_.semantics().select(selection);
  takeSelection();
}

/// Shows the placement of the selected body, or of the object's start if the object is selected.
void AssemblyController::takeSelection() {
  if (!document_.scenario()) return;
  const std::set<BodyId> ids = selectedBodies();
  const std::vector<RigidBody>& moving = document_.scenario()->objectBodies;
  const bool object = std::any_of(moving.begin(), moving.end(), [this](const RigidBody& body) {
    return document_.semantics().selectedBodies().contains(toQString(body.id));
  });
  const bool endChosen = chosen_ && chosen_->kind != AssemblyItem::Kind::Body;
  if (ids.size() == 1 && !object) {
    chosen_ = AssemblyItem{AssemblyItem::Kind::Body, *ids.begin()};
  } else if (ids.empty() && object) {
    chosen_ = AssemblyItem{AssemblyItem::Kind::Start, {}};
  } else if (!ids.empty() || !endChosen) {
    chosen_.reset();
  }
  scenePanel_->showSelection(document_.semantics().selectedBodies(), chosen_);
  showPlacement();
  enableActions();
}

void AssemblyController::showPlacement() {
  if (!document_.scenario()) return;
  if (placed_ == chosen_ && document_.isArranging()) return;  // the user's input is not arranged yet
  placed_ = chosen_;
  const QString name = chosen_ ? nameOf(*chosen_, *document_.scenario()) : QString();
  const auto pose = chosen_ ? poseOf(document_.scenario()->scenario, *chosen_) : std::nullopt;
  PlacementPoints points = pose ? placementPoints(*document_.scenario(), *chosen_) : PlacementPoints();
  const auto picked = chosen_ ? picked_.find(chosen_->bodyId) : picked_.end();
  if (picked != picked_.end()) points.picked = picked->second;
  placement_->show(name, pose, points);
  placement_->setEnabled(editable_);
  points.picked = placement_->chosenFrame();
  emit placementShown(pose ? chosen_ : std::nullopt, points);
}

void AssemblyController::placeByFrame(const RigidBody& body, const Pose& X_MF) {
  if (isInObject(*document_.scenario(), body.id)) {
    picked_[""] = X_MF;
    if (!chosen_ || chosen_->kind == AssemblyItem::Kind::Body) choose(AssemblyItem{AssemblyItem::Kind::Start, {}});
  } else {
    const AssemblyItem item{AssemblyItem::Kind::Body, bodyIdOf(body.id)};
    const auto X_WB = poseOf(document_.scenario()->scenario, item);
    if (!X_WB) return;
    picked_[item.bodyId] = inverse(*X_WB) * body.X_WB * X_MF;
    choose(item);
  }
  showPlacement();
}

void AssemblyController::enableActions() {
  const auto enable = [this](const char* id, bool enabled) { bench_.enable(id, enabled); };
  const std::size_t bodies = selectedBodies().size();
  const bool goal = document_.scenario() && std::holds_alternative<Pose>(document_.scenario()->scenario.goal);
  const std::size_t selected = selectedOfAll().size();
  enable("body.rename", editable_ && selected == 1);
  enable("body.properties", selected > 0);
  enable("assembly.add", editable_);
  enable("assembly.remove", editable_ && bodies > 0);
  enable("assembly.leave-out", editable_ && bodies > 0);
  enable("assembly.put-back", editable_ && !scenePanel_->chosenLeftOut().empty());
  enable("assembly.moves", editable_ && bodies > 0);
  enable("assembly.fit-workspace", editable_);
  enable("assembly.free-ends", editable_);
  enable("assembly.start-here", editable_);
  enable("assembly.goal-here", editable_);
  enable("assembly.goal-out", editable_ && goal);
  enable("assembly.swap", editable_ && goal);
}

}  // namespace glissade
