#include "app/window/environment_controller.h"

#include <QMouseEvent>

#include <algorithm>

#include "app/window/coarse_preview.h"
#include "app/window/scene_ray.h"
#include "widgets/model/complexity_colour.h"
#include "widgets/scene3d/environment_layers.h"
#include "widgets/scene3d/scene_pick.h"

namespace glissade {
namespace {

/// A press and a release nearer than this are a click, not a drag.
constexpr double kClickPixels = 4.0;
/// How much shorter ways through a preferred place count.
constexpr double kPreferred = 4.0;

/// What is known of places and of how the object fits holds for both: rules, start and goal do not matter to it.
bool isSameScene(const LoadedScenario& a, const LoadedScenario& b) {
  const auto sameBody = [](const RigidBody& p, const RigidBody& q) {
    return p.id == q.id && p.mesh == q.mesh && p.mobility == q.mobility && p.X_WB == q.X_WB;
  };
  const Box3& room = a.problem.bounds;
  return std::equal(a.obstacles.begin(), a.obstacles.end(), b.obstacles.begin(), b.obstacles.end(), sameBody) &&
         a.object.id == b.object.id && a.object.mesh->vertices == b.object.mesh->vertices &&
         a.object.mesh->triangles == b.object.mesh->triangles && room.min() == b.problem.bounds.min() &&
         room.max() == b.problem.bounds.max();
}

std::map<std::string, AttributeValue> mobilityOf(const SemanticEdits& edits) {
  std::map<std::string, AttributeValue> mobility;
  for (const auto& [id, attributes] : edits.bodies) {
    const auto value = attributes.find("mobility");
    if (value != attributes.end()) mobility[id] = value->second;
  }
  return mobility;
}

}  // namespace

EnvironmentController::EnvironmentController(SessionBridge& bridge, const ActionCatalogue& actions, SceneWidget& scene,
                                             QWidget* window)
    : QObject(window),
      bridge_(bridge),
      actions_(actions),
      scene_(scene),
      milestones_(document_, scene, window),
      semantics_(new SemanticsPanel(document_, actions, window)),
      plan_(new PlanPanel(actions, window)) {
  scene_.widget()->installEventFilter(this);
  connect(&builder_, &KnowledgeBuilder::started, this, [this] { semantics_->setBusy(true); });
  connect(&builder_, &KnowledgeBuilder::finished, this, &EnvironmentController::knowledgeReady);
  connect(&builder_, &KnowledgeBuilder::failed, this, [this](const Diagnostic& why) {
    semantics_->setBusy(false);
    if (why.kind != ErrorKind::Interrupted) emit failed(why);
  });
  connect(&document_, &SemanticDocument::changed, this, &EnvironmentController::documentChanged);
  connect(&document_, &SemanticDocument::selectionChanged, this, [this] {
    leaveStep();
    showEnvironment();
    enableActions();
  });
  connect(semantics_, &SemanticsPanel::identifierChosen, this, &EnvironmentController::identifyPlaces);
  connect(plan_, &PlanPanel::stepChosen, this, &EnvironmentController::showStep);
  connect(&milestones_, &MilestoneTool::moving, this, &EnvironmentController::drawPlan);
  connect(&milestones_, &MilestoneTool::refused, this, &EnvironmentController::failed);
  connectActions();
  enableActions();
}

EnvironmentController::~EnvironmentController() {
  // The undo stack tells of its own end, when those who listen are gone already.
  document_.undoStack().disconnect();
}

void EnvironmentController::connectActions() {
  const auto on = [this](const char* id, auto handler) {
    connect(actions_[QLatin1String(id)], &QAction::triggered, this, handler);
  };
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
  on("edit.undo", [this] { document_.undoStack().undo(); });
  on("edit.redo", [this] { document_.undoStack().redo(); });
  connect(&document_.undoStack(), &QUndoStack::indexChanged, this, &EnvironmentController::enableActions);
}

void EnvironmentController::open(const ScenarioPtr& scenario) {
  builder_.cancel();
  semantics_->setBusy(false);
  scenario_ = scenario;
  milestones_.setScenario(scenario);
  options_ = scenario->scenario.environment;
  semantics_->setIdentifier(options_.identifier);
  snapshot_.reset();
  shownPlan_.reset();
  plan_->setPlan(nullptr);
  document_.open(scenario);
  const bool saysSomething = !scenario->scenario.places.empty();
  if (isMultiLayer(scenario->scenario.planner) || saysSomething) {
    emit wanted();
    build(nullptr);
  }
  enableActions();
}

void EnvironmentController::rearrange(const ScenarioPtr& scenario) {
  const SceneKnowledgePtr known = document_.knowledge();
  const bool same = isSameScene(*scenario_, *scenario);
  scenario_ = scenario;
  milestones_.setScenario(scenario);
  snapshot_.reset();
  if (builder_.isBusy() || (known && !same)) {
    build(known);
  } else if (known) {
    bridge_.post(command::SetKnowledge{known});
  }
  showEnvironment();
  showPlan();
}

void EnvironmentController::identifyPlaces(const std::string& identifier) {
  options_.identifier = identifier;
  semantics_->setIdentifier(identifier);
  build(nullptr);
}

void EnvironmentController::build(const SceneKnowledgePtr& before) {
  if (!scenario_) return;
  builtMobility_ = mobilityOf(document_.edits());
  Problem problem = scenario_->problem;
  problem.scene.environment = options_;
  problem.scene.edits = std::make_shared<const SemanticEdits>(document_.edits());
  builder_.build(problem, scenario_->parameters[ParameterId::RequiredClearance], before,
                 bridge_.clock() == SessionClock::Lockstep);
}

void EnvironmentController::knowledgeReady(const SceneKnowledgePtr& knowledge) {
  semantics_->setBusy(false);
  bridge_.post(command::SetKnowledge{knowledge});
  document_.setKnowledge(knowledge);
}

void EnvironmentController::documentChanged() {
  if (!scenario_) return;
  bridge_.post(command::SetSemantics{std::make_shared<const SemanticEdits>(document_.edits())});
  if (document_.knowledge() && mobilityOf(document_.edits()) != builtMobility_) build(nullptr);
  showEnvironment();
  showPlan();
  enableActions();
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
  for (const QString& body : selection.bodies) picture.selectedBodies.insert(body.toStdString());
  scene_.view().setEnvironment(picture);
  scene_.refresh();
}

void EnvironmentController::showSnapshot(const SnapshotPtr& snapshot) {
  const bool newPlan = !snapshot_ || snapshot->coarsePlan != snapshot_->coarsePlan ||
                       snapshot->plannerId != snapshot_->plannerId || isRunning(*snapshot) != isRunning(*snapshot_);
  snapshot_ = snapshot;
  if (newPlan) showPlan();
}

/// The plan of the run while it goes on, and as long as planning again would begin with it; else a preview.
void EnvironmentController::showPlan() {
  if (!scenario_) return;
  const CoarsePlanPtr run = snapshot_ ? snapshot_->coarsePlan : nullptr;
  const bool ofRun =
      run && (isRunning(*snapshot_) ? isAboutPlaces(*run, document_)
                                    : isUpToDate(*run, document_, scenario_->problem, snapshot_->plannerId));
  QString whyNone;
  shownPlan_ = ofRun ? run : nullptr;
  if (!ofRun && snapshot_) {
    auto preview = previewPlan(document_, scenario_->problem, snapshot_->plannerId, run);
    if (preview) shownPlan_ = *preview;
    if (!preview) whyNone = QString::fromStdString(toString(preview.error()));
  }
  plan_->setPlan(shownPlan_, whyNone);
  milestones_.setPlan(shownPlan_);
  scene_.view().setShownStep(plan_->currentStep());
  drawPlan();
  enableActions();
}

void EnvironmentController::drawPlan() {
  scene_.view().setCoarsePlan(milestones_.shownPlan());
  scene_.refresh();
}

/// A step that is looked at has its place selected, so that what is done to places is done to that one.
void EnvironmentController::showStep() {
  const auto step = plan_->currentStep();
  scene_.view().setShownStep(step);
  if (step) {
    const int place = shownPlan_->steps[*step].place;
    SemanticSelection selection;
    if (place != TopologicalStep::kWholeWorkspace) selection.places.insert(place);
    document_.select(selection);
  }
  scene_.refresh();
  enableActions();
}

/// Where something else was selected the step is not looked at any more.
void EnvironmentController::leaveStep() {
  const auto step = plan_->currentStep();
  const int place = step ? shownPlan_->steps[*step].place : TopologicalStep::kWholeWorkspace;
  const bool stays = place == TopologicalStep::kWholeWorkspace ? document_.selection() == SemanticSelection{}
                                                               : document_.selection().places.contains(place);
  if (step && !stays) plan_->leaveStep();
}

void EnvironmentController::pick(const QPointF& position, bool add) {
  if (!scenario_) return;
  const Ray ray = rayThrough(scene_, position);
  const auto body = pickBody(scenario_->obstacles, ray, scene_.view().hiddenBodies());
  SemanticSelection selection = add ? document_.selection() : SemanticSelection{};
  if (document_.knowledge() && scene_.view().layerVisible(SceneLayer::Places)) {
    const int place = pickPlace(document_.knowledge()->environment->map, ray, body ? body->distance : 1e9);
    if (place != kNoPlace && !selection.places.remove(place)) selection.places.insert(place);
  } else if (body) {
    const QString id = QString::fromStdString(scenario_->obstacles[body->body].id);
    if (!selection.bodies.remove(id)) selection.bodies.insert(id);
  }
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

void EnvironmentController::toggleForbidden() {
  const SemanticModel* semantics = document_.semantics();
  bool all = true;
  for (const int place : document_.selection().places) {
    all = all && std::get<bool>(semantics->ofPlace(static_cast<std::size_t>(place), "forbidden").value);
  }
  SemanticSelection places;
  places.places = document_.selection().places;
  (void)document_.setAttribute(places, "forbidden", all ? std::nullopt : std::optional<AttributeValue>(true));
}

void EnvironmentController::togglePreferred() {
  const SemanticModel* semantics = document_.semantics();
  bool all = true;
  for (const int place : document_.selection().places) {
    all = all && std::get<double>(semantics->ofPlace(static_cast<std::size_t>(place), "preference").value) > 1.0;
  }
  SemanticSelection places;
  places.places = document_.selection().places;
  (void)document_.setAttribute(places, "preference", all ? std::nullopt : std::optional<AttributeValue>(kPreferred));
}

void EnvironmentController::setMilestone(bool here) {
  const auto step = plan_->currentStep();
  if (!step || !snapshot_ || shownPlan_->steps[*step].border < 0) return;
  document_.setMilestone(shownPlan_->steps[*step].border,
                         here ? std::optional<Pose>(snapshot_->device.q_device) : std::nullopt);
}

void EnvironmentController::enableActions() {
  const auto enable = [this](const char* id, bool enabled) { actions_[QLatin1String(id)]->setEnabled(enabled); };
  const bool places = document_.semantics() != nullptr && !document_.selection().places.isEmpty();
  const auto step = plan_->currentStep();
  const bool border = step && shownPlan_ && shownPlan_->steps[*step].border >= 0;
  enable("environment.build", scenario_ != nullptr);
  enable("attribute.add", scenario_ != nullptr);
  enable("place.forbid", places);
  enable("place.prefer", places);
  enable("milestone.set", border);
  enable("milestone.reset", border);
  enable("edit.undo", document_.undoStack().canUndo());
  enable("edit.redo", document_.undoStack().canRedo());
}

}  // namespace glissade
