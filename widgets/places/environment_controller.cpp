#include "widgets/places/environment_controller.h"

#include <QApplication>
#include <QMouseEvent>
#include <QTreeWidget>

#include <algorithm>

#include "engine/base/number_text.h"
#include "engine/files/scenario_bodies.h"
#include "engine/places/place_identifier.h"
#include "engine/planning/fine/coarse_preview.h"
#include "engine/session/start_check.h"
#include "widgets/controls/body_id_text.h"
#include "widgets/controls/complexity_colour.h"
#include "widgets/controls/diagnostic_text.h"
#include "widgets/scene3d/environment_layers.h"
#include "widgets/workbench/scene_target.h"

namespace glissade {
namespace {

/// "yes", "no", a number, or any text.
AttributeValue valueOf(const std::string& text) {
  if (text == "yes" || text == "no") return text == "yes";
  if (const auto number = toNumber(text)) return *number;
  return text;
}

/// Clicks a row with the mouse, because a highlighted row can be chosen again.
Outcome clickStep(const EnvironmentController& environment, const std::string& name) {
  auto* steps = environment.planPanel()->findChild<QTreeWidget*>(QStringLiteral("steps"));
  const auto number = toNumber(name);
  QTreeWidgetItem* item = number ? steps->topLevelItem(static_cast<int>(*number) - 1) : nullptr;
  if (item == nullptr) return wrongCommand("there is no step '" + name + "'");
  steps->scrollToItem(item);
  for (const QEvent::Type type : {QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
    QMouseEvent event(type, steps->visualItemRect(item).center(), Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(steps->viewport(), &event);
  }
  return Done{};
}

bool hasBody(const LoadedScenario& scenario, const BodyId& id) {
  const auto& obstacles = scenario.obstacles;
  return isInObject(scenario, id) ||
         std::any_of(obstacles.begin(), obstacles.end(), [&id](const RigidBody& body) { return body.id == id; });
}

Outcome select(WorkbenchDocument& workbench, const EnvironmentController& environment, const std::string& kind,
               const std::string& name) {
  SemanticDocument& document = workbench.semantics();
  SemanticSelection selection;
  if (kind == "body" && workbench.scenario() && hasBody(*workbench.scenario(), BodyId(name))) {
    selection.bodies.insert(QString::fromStdString(name));
  } else if (kind == "bodies" && workbench.scenario()) {  // "nut+bolt"
    for (const QString& id : QString::fromStdString(name).split(QLatin1Char('+'))) {
      if (hasBody(*workbench.scenario(), toBodyId(id))) selection.bodies.insert(id);
    }
  } else if (kind == "step") {
    return clickStep(environment, name);
  } else if (kind == "place" && document.semantics() != nullptr) {
    for (std::size_t place = 0; place < document.semantics()->placeCount(); ++place) {
      if (document.semantics()->placeName(place) == name) selection.places.insert(static_cast<int>(place));
    }
  }
  if (selection == SemanticSelection{}) {
    return wrongCommand("there is no " + kind + " '" + name + "'",
                        kind == "place" ? "Find the places first." : "Give its id.");
  }
  document.select(selection);
  return Done{};
}

Outcome setAttribute(SemanticDocument& document, const std::string& name, const std::string& value) {
  if (document.selection() == SemanticSelection{})
    return wrongCommand("nothing is selected", "Select a place or a body first.");
  document.endGesture();
  return document.setAttribute(document.selection().shown(), name,
                               value == "-" ? std::nullopt : std::optional<AttributeValue>(valueOf(value)));
}

/// Types the text key by key and does not commit it.
Outcome type(const EnvironmentController& environment, const std::string& name, const std::string& text) {
  const QString id = QString::fromStdString("attribute-" + name);
  auto* editor = environment.semanticsPanel()->findChild<QWidget*>(id);
  if (editor == nullptr) return wrongCommand("there is no editor of '" + name + "'", "Select a place or a body first.");
  editor->setFocus(Qt::TabFocusReason);
  for (const QChar key : QString::fromStdString(text)) {
    QKeyEvent event(QEvent::KeyPress, 0, Qt::NoModifier, key);
    QApplication::sendEvent(editor, &event);
  }
  return Done{};
}

Outcome define(SemanticDocument& document, const std::string& name, const std::string& type, const std::string& owner) {
  AttributeDefinition definition;
  const auto known = kAttributeTypeNames.find(type);
  if (!known) return wrongCommand("there is no type '" + type + "'");
  definition.name = name;
  definition.label = Message(name);
  definition.type = *known;
  definition.owner = kAttributeOwnerNames.find(owner).value_or(AttributeOwner::Place);
  definition.initial = initialValue(definition);
  return document.addDefinition(definition);
}

Outcome expectAttribute(const SemanticDocument& document, const std::string& name, const std::string& value) {
  const auto check = [&](const ProvenValue& found) -> Outcome {
    if (toText(found.value) == value) return Done{};
    return unmetExpectation("'" + name + "' is " + toText(found.value) + ", not " + value);
  };
  const SemanticSelection shown = document.selection().shown();
  const AttributeOwner owner = shown.owner();
  if (document.table().find(owner, name) == nullptr) return wrongCommand("there is no attribute '" + name + "'");
  for (const int place : shown.places) {
    const Outcome met = check(document.semantics()->ofPlace(static_cast<std::size_t>(place), name));
    if (!met) return met;
  }
  for (const QString& body : shown.bodies) {
    const Outcome met = check(document.bodyValue(body, name));
    if (!met) return met;
  }
  return Done{};
}

Outcome expectWay(const EnvironmentController& environment, const std::string& names) {
  std::string way;
  if (const CoarsePlanPtr& plan = environment.shownPlan()) {
    for (const TopologicalStep& step : plan->steps) way += (way.empty() ? "" : ",") + step.placeName;
  }
  if (way == names) return Done{};
  return unmetExpectation("the coarse path leads through " + (way.empty() ? "nothing" : way) + ", not " + names);
}

Outcome expectStep(const EnvironmentController& environment, const std::string& name) {
  const auto step = environment.planPanel()->currentStep();
  const std::string found = step ? environment.shownPlan()->steps[*step].placeName : "-";
  return found == name ? Outcome(Done{})
                       : unmetExpectation("the step that is highlighted is " + found + ", not " + name);
}

Outcome expectPlan(const EnvironmentController& environment, const std::string& what) {
  const CoarsePlanPtr& plan = environment.shownPlan();
  const std::string found = !plan ? "none" : plan->attempt == 0 ? "preview" : "tried";
  return found == what ? Outcome(Done{})
                       : unmetExpectation("the coarse plan that is shown is " + found + ", not " + what);
}

Outcome identify(EnvironmentController& environment, const std::string& identifier) {
  const PlaceIdentifierRegistry registry = makePlaceIdentifierRegistry();
  if (registry.find(identifier) == nullptr) return wrongCommand("places cannot be found by '" + identifier + "'");
  environment.identifyPlaces(identifier);
  return Done{};
}

/// Adds the script commands about places, attributes and the coarse plan.
void addEnvironmentCommands(const Workbench& bench, EnvironmentController& environment) {
  using Words = ScriptCommands::Words;
  ScriptCommands& scripts = bench.scripts;
  SemanticDocument& document = bench.document.semantics();
  scripts.add("select", 2, [&bench, &environment](const Words& words) {
    return select(bench.document, environment, words[0], words[1]);
  });
  scripts.add("attribute", 2, [&document](const Words& words) { return setAttribute(document, words[0], words[1]); });
  scripts.add("type", 2, [&environment](const Words& words) { return type(environment, words[0], words[1]); });
  scripts.add("define", 3, [&document](const Words& words) { return define(document, words[0], words[1], words[2]); });
  scripts.add("expect-attribute", 2,
              [&document](const Words& words) { return expectAttribute(document, words[0], words[1]); });
  scripts.add("expect-way", 1, [&environment](const Words& words) { return expectWay(environment, words[0]); });
  scripts.add("expect-step", 1, [&environment](const Words& words) { return expectStep(environment, words[0]); });
  scripts.add("expect-plan", 1, [&environment](const Words& words) { return expectPlan(environment, words[0]); });
  scripts.add("identify", 1, [&environment](const Words& words) { return identify(environment, words[0]); });
}

/// A press and a release within this distance are a click, not a drag.
constexpr double kClickPixels = 4.0;
/// Factor by which paths through a preferred place count as shorter.
constexpr double kPreferred = 4.0;

std::map<std::string, AttributeValue> mobilityOf(const SemanticEdits& edits) {
  std::map<std::string, AttributeValue> mobility;
  for (const auto& [id, attributes] : edits.bodies) {
    const auto value = attributes.find("mobility");
    if (value != attributes.end()) mobility[id] = value->second;
  }
  return mobility;
}

}  // namespace

EnvironmentController::EnvironmentController(const Workbench& bench)
    : QObject(&bench.window),
      bench_(bench),
      document_(bench.document.semantics()),
      milestones_(bench.document, bench.scene, &bench.window),
      semantics_(new SemanticsPanel(document_, bench.actions, &bench.window)),
      plan_(new PlanPanel(bench.actions, &bench.window)) {
  bench.scene.widget()->installEventFilter(this);
  connect(&builder_, &KnowledgeBuilder::started, this, [this] { semantics_->setBusy(true); });
  connect(&builder_, &KnowledgeBuilder::finished, this, [this](const SceneKnowledgePtr& knowledge) {
    semantics_->setBusy(false);
    bench_.document.setKnowledge(knowledge);
  });
  connect(&builder_, &KnowledgeBuilder::failed, this, [this](const Diagnostic& why) {
    semantics_->setBusy(false);
    if (why.kind != ErrorKind::Interrupted) showError(why);
  });
  connect(&preview_, &BackgroundTask::failed, this, &EnvironmentController::showError);
  connect(&bench.document, &WorkbenchDocument::changed, this, &EnvironmentController::followDocument);
  connect(&bench.run, &ShownRun::changed, this, &EnvironmentController::followRun);
  connect(&document_, &SemanticDocument::selectionChanged, this, [this] {
    leaveStep();
    showEnvironment();
    enableActions();
  });
  connect(semantics_, &SemanticsPanel::identifierChosen, this, &EnvironmentController::identifyPlaces);
  connect(plan_, &PlanPanel::stepChosen, this, &EnvironmentController::showStep);
  connect(&milestones_, &MilestoneTool::moved, this, &EnvironmentController::drawPlan);
  connect(&milestones_, &MilestoneTool::refused, this, &EnvironmentController::refuseMilestone);
  connectActions();
  enableActions();
  addEnvironmentCommands(bench, *this);
}

void EnvironmentController::connectActions() {
  const auto on = [this](const char* id, auto handler) { bench_.onAction(id, this, handler); };
  on("environment.build", [this] { build(nullptr); });
  on("attribute.add", [this] { semantics_->addAttribute(); });
  on("attribute.rename", [this] { semantics_->renameAttribute(); });
  on("attribute.remove", [this] { semantics_->removeAttribute(); });
  on("attribute.remove-strays", [this] { document_.removeStrays(); });
  on("place.forbid", [this] { toggleForbidden(); });
  on("place.prefer", [this] { togglePreferred(); });
  on("milestone.set", [this] { setMilestone(true); });
  on("milestone.reset", [this] { setMilestone(false); });
  on("view.finer-cells", [this] { changeCellLevel(1); });
  on("view.coarser-cells", [this] { changeCellLevel(-1); });
}

void EnvironmentController::showError(const Diagnostic& why) {
  bench_.messages.showError(tr("The places cannot be found"), why);
}

void EnvironmentController::refuseMilestone(const Diagnostic& why) {
  bench_.messages.showError(tr("The milestone was not moved"), why);
}

void EnvironmentController::followDocument(Changes what) {
  if (what & Change::Options) semantics_->setIdentifier(bench_.document.options().identifier);
  if (what & Change::Scenario) {
    startScenario();
  } else if (what & (Change::Arrangement | Change::Semantics)) {
    updateModel(what);
  }
  if (what & (Change::Arrangement | Change::Semantics | Change::Knowledge)) {
    showEnvironment();
    showPlan();
  }
}

/// Builds the environment model of a scenario about places, and raises the panels about places.
void EnvironmentController::startScenario() {
  builder_.cancel();
  semantics_->setBusy(false);
  const Scenario& scenario = bench_.document.scenario()->scenario;
  if (!isMultiLayer(scenario.planner) && scenario.places.empty()) return;
  for (const char* panel : {"panel.semantics", "panel.plan"}) bench_.actions[QLatin1String(panel)]->trigger();
  bench_.scene.widget()->setFocus();  // the focus lets keys steer the object
  build(nullptr);
}

bool EnvironmentController::isModelled(const LoadedScenario& scenario) const {
  const auto sameBody = [](const RigidBody& p, const RigidBody& q) {
    return p.id == q.id && p.mesh == q.mesh && p.mobility == q.mobility && p.X_WB == q.X_WB;
  };
  const Box3& workspace = scenario.problem.bounds;
  return std::equal(modelled_.obstacles.begin(), modelled_.obstacles.end(), scenario.obstacles.begin(),
                    scenario.obstacles.end(), sameBody) &&
         modelled_.object.id == scenario.object.id &&
         modelled_.object.mesh->vertices == scenario.object.mesh->vertices &&
         modelled_.object.mesh->triangles == scenario.object.mesh->triangles &&
         modelled_.workspace.min() == workspace.min() && modelled_.workspace.max() == workspace.max();
}

/// Updates the model after an edit. It depends on bodies, workspace and mobility, not on rules, start and goal.
void EnvironmentController::updateModel(Changes what) {
  const SceneKnowledgePtr known = bench_.document.knowledge();
  if (!known && !builder_.isBusy()) return;
  if (mobilityOf(document_.edits()) != modelled_.mobility) {
    build(nullptr);
  } else if (builder_.isBusy() || !isModelled(*bench_.document.scenario())) {
    build(known);
  } else if (what & Change::Arrangement) {
    bench_.document.setKnowledge(known);  // the model is still valid, but the new session has none
  }
}

void EnvironmentController::identifyPlaces(const std::string& identifier) {
  EnvironmentOptions options = bench_.document.options();
  options.identifier = identifier;
  bench_.document.setOptions(options);
  build(nullptr);
}

void EnvironmentController::build(const SceneKnowledgePtr& before) {
  const ScenarioPtr& scenario = bench_.document.scenario();
  if (!scenario) return;
  modelled_ = {scenario->obstacles, scenario->object, scenario->problem.bounds, mobilityOf(document_.edits())};
  Problem problem = scenario->problem;
  problem.scene.environment = bench_.document.options();
  problem.scene.edits = bench_.document.edits();
  builder_.build(problem, scenario->parameters[ParameterId::RequiredClearance], before,
                 bench_.session.clock() == SessionClock::Lockstep);
}

void EnvironmentController::showEnvironment() {
  EnvironmentPicture picture;
  picture.knowledge = document_.knowledge();
  picture.finestCellLevel = finestCellLevel_;
  if (const SemanticModel* semantics = document_.semantics()) {
    for (std::size_t place = 0; place < semantics->placeCount(); ++place) {
      const double complexity = std::get<double>(semantics->ofPlace(place, "complexity").value);
      const bool cluttered = std::get<bool>(semantics->ofPlace(place, "cluttered").value);
      picture.placeColours.push_back(complexityColour(static_cast<int>(complexity), cluttered));
      picture.placeNames.push_back(semantics->placeName(place));
    }
  }
  const SemanticSelection& selection = document_.selection();
  picture.selectedPlaces.insert(selection.places.begin(), selection.places.end());
  for (const QString& body : document_.selectedBodies()) picture.selectedBodies.insert(toBodyId(body));
  bench_.scene.view().setEnvironment(picture);
  bench_.scene.refresh();
}

void EnvironmentController::followRun(const SnapshotPtr& snapshot) {
  const bool newPlan = !snapshot_ || snapshot->coarsePlan != snapshot_->coarsePlan ||
                       snapshot->plannerId != snapshot_->plannerId || isRunning(*snapshot) != isRunning(*snapshot_);
  snapshot_ = snapshot;
  if (newPlan) showPlan();
}

/// Shows the plan of the run during the run, and afterwards as long as a new run would begin with that plan; else shows
/// a preview, which is made in the background.
void EnvironmentController::showPlan() {
  if (!snapshot_) return;
  const PreviewQuestion question{bench_.document.scenario()->problem, snapshot_->plannerId, document_.knowledge(),
                                 bench_.document.edits(), snapshot_->coarsePlan};
  const CoarsePlanPtr& run = question.run;
  const bool ofRun =
      run && (isRunning(*snapshot_) ? isAboutPlaces(*run, question.knowledge) : isUpToDate(*run, question));
  if (ofRun) {
    preview_.cancel();
    takePlan(run);
    return;
  }
  if (shownPlan_ && !isAboutPlaces(*shownPlan_, question.knowledge)) takePlan(nullptr);
  const bool quick = !question.knowledge || !isMultiLayer(question.strategy);
  const auto work = [this, question](const WorkWatch&) -> BackgroundTask::Delivery {
    return [this, plan = previewPlan(question)] {
      takePlan(plan ? *plan : nullptr, plan ? QString() : diagnosticLine(plan.error()));
    };
  };
  preview_.start(GLISSADE_TEXT("planning coarsely"), work, quick || bench_.session.clock() == SessionClock::Lockstep);
}

void EnvironmentController::takePlan(const CoarsePlanPtr& plan, const QString& whyNone) {
  shownPlan_ = plan;
  plan_->setPlan(shownPlan_, whyNone);
  milestones_.setPlan(shownPlan_);
  bench_.scene.view().setShownStep(plan_->currentStep());
  drawPlan();
  enableActions();
}

void EnvironmentController::drawPlan() {
  bench_.scene.view().setCoarsePlan(milestones_.shownPlan());
  bench_.scene.refresh();
}

/// Selects the place of the step that is looked at, so that edits of places apply to it.
void EnvironmentController::showStep() {
  const auto step = plan_->currentStep();
  bench_.scene.view().setShownStep(step);
  if (step) {
    const int place = shownPlan_->steps[*step].place;
    SemanticSelection selection;
    if (place != TopologicalStep::kWholeWorkspace) selection.places.insert(place);
    document_.select(selection);
  }
  bench_.scene.refresh();
  enableActions();
}

/// Leaves the step if the selection no longer holds its place.
void EnvironmentController::leaveStep() {
  const auto step = plan_->currentStep();
  const int place = step ? shownPlan_->steps[*step].place : TopologicalStep::kWholeWorkspace;
  const bool stays = place == TopologicalStep::kWholeWorkspace ? document_.selection() == SemanticSelection{}
                                                               : document_.selection().places.contains(place);
  if (step && !stays) plan_->leaveStep();
}

void EnvironmentController::pick(const QPointF& position, bool add) {
  if (!bench_.document.scenario()) return;
  const SceneTarget target = targetAt(bench_, position);
  SemanticSelection selection = add ? document_.selection() : SemanticSelection{};
  if (target.place != kNoPlace && !selection.places.remove(target.place)) selection.places.insert(target.place);
  if (target.body && !selection.bodies.remove(*target.body)) selection.bodies.insert(*target.body);
  document_.select(selection);
}

bool EnvironmentController::eventFilter(QObject* watched, QEvent* event) {
  const auto* mouse = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonRelease
                          ? static_cast<QMouseEvent*>(event)
                          : nullptr;
  if (mouse != nullptr && mouse->button() == Qt::LeftButton) {
    if (event->type() == QEvent::MouseButtonPress) {
      pressed_ = mouse->localPos();
    } else if ((mouse->localPos() - pressed_).manhattanLength() < kClickPixels) {
      pick(mouse->localPos(), mouse->modifiers().testFlag(Qt::ControlModifier));
    }
  }
  return QObject::eventFilter(watched, event);
}

void EnvironmentController::changeCellLevel(int by) {
  finestCellLevel_ = std::clamp(finestCellLevel_ + by, 1, Octree::kDeepest);
  showEnvironment();
}

void EnvironmentController::toggle(const std::string& attribute, const AttributeValue& value,
                                   bool (*isSet)(const AttributeValue&)) {
  SemanticSelection places;
  places.places = document_.selection().places;
  const bool all = std::all_of(places.places.begin(), places.places.end(), [&](int place) {
    return isSet(document_.semantics()->ofPlace(static_cast<std::size_t>(place), attribute).value);
  });
  (void)document_.setAttribute(places, attribute, all ? std::nullopt : std::optional<AttributeValue>(value));
}

void EnvironmentController::toggleForbidden() {
  toggle("forbidden", true, [](const AttributeValue& value) { return std::get<bool>(value); });
}

void EnvironmentController::togglePreferred() {
  toggle("preference", kPreferred, [](const AttributeValue& value) { return std::get<double>(value) > 1.0; });
}

void EnvironmentController::setMilestone(bool here) {
  const auto step = plan_->currentStep();
  if (!step || !snapshot_ || shownPlan_->steps[*step].border < 0) return;
  std::optional<Pose> q;
  if (here) {
    q = snapshot_->device.q_device;
    const Problem& problem = bench_.document.scenario()->problem;
    if (const Outcome sound = checkMilestone(problem, *problem.world->makeQuery(), *q); !sound) {
      refuseMilestone(sound.error());
      return;
    }
  }
  document_.setMilestone(shownPlan_->steps[*step].border, q);
}

void EnvironmentController::enableActions() {
  const auto enable = [this](const char* id, bool enabled) { bench_.enable(id, enabled); };
  const bool open = bench_.document.scenario() != nullptr;
  const bool places = document_.semantics() != nullptr && !document_.selection().places.isEmpty();
  const auto step = plan_->currentStep();
  const bool border = step && shownPlan_ && shownPlan_->steps[*step].border >= 0;
  enable("environment.build", open);
  for (const char* id : {"view.finer-cells", "view.coarser-cells"}) enable(id, open);
  enable("attribute.add", open);
  enable("place.forbid", places);
  enable("place.prefer", places);
  enable("milestone.set", border);
  enable("milestone.reset", border);
}

}  // namespace glissade
