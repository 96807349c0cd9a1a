#include "widgets/sequence/access_controller.h"

#include <QActionGroup>

#include <algorithm>
#include <array>
#include <utility>

#include "engine/sequence/step_way.h"
#include "widgets/paths/path_panel.h"
#include "widgets/sequence/access_texts.h"
#include "widgets/sequence/sequence_controller.h"

namespace glissade {
namespace {

constexpr std::array<std::pair<const char*, HandSize>, 3> kSizes{{{"access.small", HandSize::SmallWoman},
                                                                  {"access.average", HandSize::Average},
                                                                  {"access.large", HandSize::LargeMan}}};

ReachPicture pictureOf(const MotionAccess& motion, const Pose& moved, const MeshPtr& forearm) {
  if (!motion.hasHold()) return {};
  const PlacedHand placed = placedHand(motion, moved);
  ReachPicture picture{{{placed.hand, placed.X_WH}, {forearm, placed.X_WF}}, placed.isFree};
  if (placed.tool) picture.parts.push_back({placed.tool, placed.X_WT, true});
  return picture;
}

}  // namespace

AccessController::AccessController(const Workbench& bench, SequenceController& sequence, PathPanel& pathPanel)
    : QObject(&bench.window), bench_(bench), sequence_(sequence), pathPanel_(pathPanel) {
  addSizes();
  bench_.onAction("access.sequence", this, [this] { checkSequence(); });
  bench_.onAction("access.path", this, [this] { checkPath(); });
  bench_.onAction("access.next", this, [this] { showNextUnreached(); });
  connect(bench_.actions["access.show"], &QAction::toggled, this, &AccessController::updateHand);
  connect(sequence.panel(), &SequencePanel::sceneChanged, this, &AccessController::updateHand);
  connect(&sequence, &SequenceController::planShown, this, [this] {
    enableActions();
    updateHand();
  });
  connect(&pathPanel, &PathPanel::poseShown, this, &AccessController::updateHand);
  connect(&bench.run, &ShownRun::changed, this, &AccessController::followPath);
  connect(&bench.document, &WorkbenchDocument::changed, this, [this](Changes what) {
    if (what & (Change::Results | Change::Scenario | Change::Arrangement)) followPath();
  });
  enableActions();
  addCommands();
}

void AccessController::addSizes() {
  auto* group = new QActionGroup(this);
  for (const auto& [id, size] : kSizes) {
    QAction* action = group->addAction(bench_.actions[QLatin1String(id)]);
    if (size == person_.size) action->setChecked(true);
    connect(action, &QAction::triggered, this, [this, size = size] { setSize(size); });
  }
}

/// Repeats the check that is shown, with the new size.
void AccessController::setSize(HandSize size) {
  if (size == person_.size) return;
  person_.size = size;
  if (sequence_.shown().access) {
    checkSequence();
  } else if (checkedPath_) {
    checkPath();
  }
}

void AccessController::checkSequence() {
  const ShownPlan& shown = sequence_.shown();
  if (!shown.plan || !shown.product || shown.growing) return;
  const auto work = [this, plan = shown.plan, product = shown.product,
                     person = person_](const WorkWatch& watch) -> BackgroundTask::Delivery {
    auto found = std::make_shared<Result<PlanAccess>>(planAccess(*product, *plan, person, watch));
    return [this, plan, person, found] {
      if (!*found) {
        bench_.messages.showError(tr("Hand access was not checked"), found->error());
        return;
      }
      const auto access = std::make_shared<const PlanAccess>(std::move(**found));
      bench_.actions["access.show"]->setChecked(true);
      sequence_.note(plan, sequence_.shown().check, access);
      bench_.messages.showStatus(tr("Hand (%1): %2 of %3 steps are reachable and visible; sampled, no proof")
                                     .arg(handSizeText(person.size))
                                     .arg(access->reached())
                                     .arg(access->count()));
    };
  };
  bench_.work.run(tr("Checking hand access"), work);
}

std::shared_ptr<const Path> AccessController::path() const {
  if (bench_.run.isLive()) return bench_.document.results().path;
  const SnapshotPtr& snapshot = bench_.run.snapshot();
  return snapshot ? snapshot->path : nullptr;
}

void AccessController::checkPath() {
  const auto path = this->path();
  const ScenarioPtr scenario = bench_.document.scenario();
  if (!path || !scenario) return;
  const auto work = [this, path, scenario, person = person_](const WorkWatch& watch) -> BackgroundTask::Delivery {
    auto found = std::make_shared<Result<PathAccess>>(
        pathAccess(scenario->obstacles, scenario->object, path->configurations(), person, watch));
    return [this, path, found] {
      if (path != this->path()) return;
      if (!*found) {
        bench_.messages.showError(tr("Hand access was not checked"), found->error());
        return;
      }
      takePath(path, **found);
    };
  };
  bench_.work.run(tr("Checking hand access"), work);
}

void AccessController::takePath(const std::shared_ptr<const Path>& path, const PathAccess& access) {
  checkedPath_ = path;
  pathAccess_ = access;
  bench_.actions["access.show"]->setChecked(true);
  updateHand();
  enableActions();
  std::vector<RigidBody> bodies = bench_.document.scenario()->obstacles;
  bodies.push_back(bench_.document.scenario()->object);
  bench_.messages.showStatus(
      tr("Hand (%1): %2; sampled, no proof").arg(handSizeText(person_.size), accessText(access.motion, bodies)));
}

void AccessController::followPath() {
  if (checkedPath_ && checkedPath_ != path()) {
    checkedPath_ = nullptr;
    pathAccess_ = {};
  }
  updateHand();
  enableActions();
}

bool AccessController::showsSteps() const {
  return sequence_.shown().access && (bench_.scene.view().showsSequence() || !checkedPath_);
}

/// Searches in the order of the table, after the step that is shown.
void AccessController::showNextUnreached() {
  SequencePanel& panel = *sequence_.panel();
  if (!showsSteps()) {
    const double share = pathAccess_.motion.hand.share;
    pathPanel_.showAt(pathAccess_.beginsAtEnd ? 1.0 - share : share);
    return;
  }
  const auto& steps = sequence_.shown().access->steps;
  const std::size_t count = steps.size();
  const bool forwards = panel.order() == PlanOrder::Removal;
  std::size_t step = panel.chosenStep().value_or(forwards ? count - 1 : 0);
  for (std::size_t i = 0; i < count; ++i) {
    step = (step + (forwards ? 1 : count - 1)) % count;
    if (steps[step].isReachedAndSeen()) continue;
    panel.chooseStep(step);
    panel.showTime(
        PlayedMotion{step, steps[step].motion, std::min(0.99, steps[step].hand.share)}.time(*sequence_.shown().plan));
    bench_.messages.showStatus(accessText(steps[step], sequence_.shown().product->bodies));
    return;
  }
  bench_.messages.showStatus(tr("Hand access to all steps"));
}

ReachPicture AccessController::pictureOfStep() const {
  const ShownPlan& shown = sequence_.shown();
  const double time = sequence_.panel()->time();
  const bool isAtStep = time < static_cast<double>(shown.access->steps.size());
  if (!isAtStep || sequence_.panel()->exploded() > 0.0) return {};
  const PlayedMotion at = playedMotionAt(time, *shown.plan);
  const StepAccess& access = shown.access->steps[at.step];
  if (access.motion != at.motion) return {};
  const StepMotion& moving = shown.plan->steps[at.step].motions[at.motion];
  const StepWay way(moving, shown.product->body(moving.body));
  return pictureOf(access, way.movedAt(at.share * way.length()), shown.access->forearm);
}

ReachPicture AccessController::pictureOnPath() const {
  const Pose moved = bench_.scene.view().objectPose() * inverse(pathAccess_.X_WB);
  return pictureOf(pathAccess_.motion, moved, pathAccess_.forearm);
}

void AccessController::updateHand() {
  ReachPicture picture;
  if (bench_.actions["access.show"]->isChecked()) {
    if (showsSteps()) {
      picture = pictureOfStep();
    } else if (checkedPath_) {
      picture = pictureOnPath();
    }
  }
  const bool isDrawn = !picture.parts.empty();
  const bool wasDrawn = std::exchange(isDrawn_, isDrawn);
  if (!wasDrawn && !isDrawn) return;
  if (!wasDrawn) fitWithHand(picture);
  bench_.scene.view().setReach(std::move(picture));
  bench_.scene.refresh();
}

/// Fits the view to the product and the hand, which may be larger. The forearm need not be in view.
void AccessController::fitWithHand(const ReachPicture& picture) {
  SceneView& view = bench_.scene.view();
  const ReachPicture::Part& hand = picture.parts.front();
  view.camera().zoomTo(view.extent().merged(boundingBox(*hand.mesh, hand.X_WM)));
}

void AccessController::enableActions() {
  const ShownPlan& shown = sequence_.shown();
  const bool hasSteps = shown.plan && shown.product && !shown.growing && !shown.plan->steps.empty();
  const bool isChecked = shown.access != nullptr || checkedPath_ != nullptr;
  bench_.enable("access.sequence", hasSteps);
  bench_.enable("access.path", path() != nullptr);
  bench_.enable("access.show", isChecked);
  bench_.enable("access.next", isChecked);
}

Outcome AccessController::expectAccess(const ScriptCommands::Words& words) const {
  std::string found = "none";
  if (sequence_.shown().access) {
    found = std::to_string(sequence_.shown().access->reached());
  } else if (checkedPath_) {
    found = kHandAccessNames.of(pathAccess_.motion.hand.access);
  }
  if (found == words[0]) return Done{};
  return unmetExpectation("the access is " + found + ", not " + words[0]);
}

void AccessController::addCommands() {
  bench_.scripts.add("expect-access", 1, [this](const ScriptCommands::Words& words) { return expectAccess(words); });
}

}  // namespace glissade
