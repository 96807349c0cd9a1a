#include "widgets/run/assist_controller.h"

#include <utility>

#include "engine/base/number_text.h"
#include "engine/operator/device_registry.h"
#include "engine/session/grown_roadmap.h"
#include "widgets/controls/frame_name.h"
#include "widgets/controls/length_text.h"
#include "widgets/run/strategy_use.h"
#include "widgets/scene3d/camera_controller.h"

namespace glissade {
namespace {

/// Seconds of planning before the first offer of help; each later offer waits twice as long.
constexpr double kFirstOffer = 5.0;

/// Distance of the pose ahead on a passage to which the hand is led, in radii of the object.
constexpr double kAheadOnPassage = 0.5;
/// Least time between two hints, milliseconds.
constexpr int kHintPeriod = 100;

/// The share of the work that searches a whole path; the rest searches gaps.
constexpr double kWholeWay = 0.6;

/// The search goes on without a path, or ended without one.
bool isStuck(const SessionSnapshot& snapshot) {
  return snapshot.run > 0 && !snapshot.path && (isRunning(snapshot) || searchFailed(snapshot));
}

bool isPaused(const Workbench& bench) { return bench.run.snapshot()->state == SessionState::Paused; }

QString keyOf(const char* action, const Workbench& bench) {
  return bench.actions[QLatin1String(action)]->shortcut().toString(QKeySequence::NativeText);
}

}  // namespace

HandHint::HandHint(const Workbench& bench) : bench_(bench), hint_(new SceneHint(bench.scene.widget())) {
  bench.actions["layer.keys"]->setChecked(true);
  connect(&bench.run, &ShownRun::changed, this, &HandHint::write);
  connect(bench.actions["layer.keys"], &QAction::toggled, this, &HandHint::write);
  connect(bench.actions["operator.camera"], &QAction::toggled, this, &HandHint::write);
  connect(bench.actions["operator.frame"], &QAction::changed, this, &HandHint::write);
}

void HandHint::ask(const QString& text) {
  asked_ = text;
  write();
}

void HandHint::lead(const std::vector<KeyToHold>& keys) {
  const QString motions = textOf(keys, isByKeys());
  lead_ = motions.isEmpty() || !isByKeys() ? motions : tr("Hold %1").arg(motions);
  write();
}

void HandHint::stop(const QString& body, const std::vector<const SteeringKey*>& free) {
  if (body.isEmpty()) {
    stopped_.clear();
  } else if (free.empty()) {
    stopped_ = tr("Touches %1: turn the object, or go back.").arg(body);
  } else {
    stopped_ = tr("Touches %1: back off or slide along it. Free: %2").arg(body, textOf(free, isByKeys()));
  }
  write();
}

/// Writes the lines only if they changed; most snapshots change nothing.
void HandHint::write() {
  QStringList lines;
  for (const QString& line : {state(), asked_, stopped_.isEmpty() ? lead_ : stopped_, toGoal(), keys()}) {
    if (!line.isEmpty()) lines << line;
  }
  const QString text = lines.join(QLatin1Char('\n'));
  if (text == shown_) return;
  shown_ = text;
  hint_->write(text);
}

/// A person leads the object in the run that is shown.
bool HandHint::isByHand() const {
  const SnapshotPtr& snapshot = bench_.run.snapshot();
  return snapshot && bench_.run.isLive() && isRunning(*snapshot) && isPerson(bench_.session.deviceId()) &&
         followsHand(snapshot->plannerId);
}

/// Why the object, or the search, does not go on.
QString HandHint::state() const {
  if (!isByHand()) return {};
  if (isPaused(bench_)) return tr("Paused: press %1 to go on.").arg(keyOf("run.pause", bench_));
  return bench_.run.snapshot()->waitsForHand ? tr("The run begins when you move the object.") : QString();
}

/// The move and the turn from the hand to the goal.
QString HandHint::toGoal() const {
  if (!isByHand() || isPaused(bench_)) return {};
  const Pose* goal = std::get_if<Pose>(&bench_.document.scenario()->problem.goal);
  if (goal == nullptr) return {};
  const Pose& q = bench_.run.snapshot()->device.q_device;
  return tr("To the goal: %1").arg(distanceText(q, *goal));
}

bool HandHint::isByKeys() const {
  const std::string& device = bench_.session.deviceId();
  return device == kAnyDevice || device == "keyboard";
}

QString HandHint::keys() const {
  if (!isByHand() || !isByKeys() || isPaused(bench_)) return {};
  if (!bench_.actions["layer.keys"]->isChecked()) return {};
  const auto key = [this](const char* id) { return keyOf(id, bench_); };
  const MotionFrame frame = bench_.session.hand()->keyboard.shaping.get().frame;
  const QString moved =
      bench_.actions["operator.camera"]->isChecked() ? tr("keys move the object again") : tr("keys move the camera");
  const QString keys =
      tr("A D W S Q E: move · J L I K U O: turn · Shift: slow · F: change the axes (now: %1) · %2: %3 · "
         "%4: go where the search is stuck");
  return keys.arg(frameName(frame), key("operator.camera"), moved, key("assist.go"));
}

AssistController::AssistController(const Workbench& bench) : QObject(&bench.window), bench_(bench), hint_(bench) {
  bench.onAction("assist.go", this, [this] { go(); });
  bench.onAction("assist.show", this, [this] { find(Then::Show); });
  for (const char* id : {"assist.go", "assist.show"}) bench.enable(id, false);
  clock_.start();
  lead_.setSingleShot(true);
  lead_.setInterval(kHintPeriod);
  connect(&lead_, &QTimer::timeout, this, [this] {
    lead();
    noticeStop();
  });
  connect(&offers_, &BackgroundTask::failed, &bench.work, &WorkController::reportFailure);
  connect(&bench.run, &ShownRun::changed, this, &AssistController::followRun);
  connect(&bench.document, &WorkbenchDocument::changed, this, [this](Changes what) {
    if (!(what & (Change::Scenario | Change::Arrangement))) return;
    starting_ = false;
    show(nullptr);
  });
  addCommands();
}

void AssistController::show(const HelpPlacesPtr& places) {
  offers_.cancel();
  places_ = places && !places->empty() ? places : nullptr;
  chosen_ = 0;
  taken_ = false;
  guide_.reset();
  sight_.reset();
  object_.reset();
  draw();
}

void AssistController::choose(std::size_t place) {
  chosen_ = place;
  taken_ = false;
  draw();
}

void AssistController::followRun(const SnapshotPtr& snapshot) {
  const bool stuck = bench_.run.isLive() && isStuck(*snapshot);
  for (const char* id : {"assist.go", "assist.show"}) bench_.enable(id, stuck);
  if (starting_) {
    if (bench_.session.isStarting() || snapshot->state == SessionState::Idle) return;
    starting_ = false;
    if (isRunning(*snapshot)) {
      run_ = snapshot->run;
      takeHand();
    }
  }
  const bool wasRunning = std::exchange(running_, bench_.run.isLive() && isRunning(*snapshot));
  if (wasRunning && snapshot->state == SessionState::Stopped) show(nullptr);
  if (snapshot->run != run_) nextOffer_ = kFirstOffer;
  if (places_ && (!stuck || snapshot->run != run_)) show(nullptr);
  run_ = snapshot->run;
  if (stuck) offerInTime(*snapshot);
  if (bench_.session.clock() == SessionClock::Lockstep) {
    lead();
    noticeStop();
  } else if (!lead_.isActive()) {
    lead_.start();
  }
}

void AssistController::offerInTime(const SessionSnapshot& snapshot) {
  if (bench_.session.clock() == SessionClock::Lockstep || snapshot.state != SessionState::Planning) return;
  if (taken_ || offers_.isBusy() || snapshot.planningSeconds < nextOffer_) return;
  if (!isPerson(bench_.session.deviceId()) || !followsHand(snapshot.plannerId)) return;
  offers_.start(GLISSADE_TEXT("looking for places to help"), search(Then::Show), false);
}

BackgroundTask::Work AssistController::search(Then then) {
  return [this, then, scenario = bench_.document.scenario(),
          shown = bench_.session.snapshot()](const WorkWatch& watch) -> BackgroundTask::Delivery {
    const GrownRoadmap grown = grownRoadmap(*shown);
    const Problem& problem = scenario->problem;
    const auto wholeWay =
        leastPenetration(problem, shown->parameters, shown->seed, kWholeWayBudget, watch.part(0.0, kWholeWay));
    const auto places = std::make_shared<const std::vector<HelpPlace>>(
        helpPlaces(problem, grown.nodes, grown.edges, shown->parameters, shown->seed, wholeWay, kHelpGaps, kGapBudget,
                   watch.part(kWholeWay, 1.0)));
    return [this, then, run = shown->run, places] {
      const SessionSnapshot& now = *bench_.session.snapshot();
      if (now.run != run || !bench_.run.isLive() || !isStuck(now)) return;
      nextOffer_ = 2.0 * bench_.session.snapshot()->planningSeconds;
      show(places);
      if (places->empty()) bench_.messages.showStatus(tr("No place to help was found."));
      if (then == Then::Go && places_) go();
    };
  };
}

/// A search under way is not begun anew by a person who asks again.
void AssistController::find(Then then) {
  if (!search_.expired()) return;
  const auto underWay = std::make_shared<char>();
  search_ = underWay;
  bench_.work.run(tr("Looking for places to help"),
                  [underWay, work = search(then)](const WorkWatch& watch) { return work(watch); });
}

/// Takes the hand to the chosen place, or to the next one if the hand was there already. After the last one it searches
/// places again.
void AssistController::go() {
  if (!places_ || (taken_ && chosen_ + 1 == places_->size())) {
    find(Then::Go);
    return;
  }
  if (taken_) ++chosen_;
  const SessionSnapshot& now = *bench_.session.snapshot();
  if (isRunning(now) && isPerson(bench_.session.deviceId()) && followsHand(now.plannerId)) {
    takeHand();
  } else {
    startByHand();
  }
}

/// Starts a run by hand. A new run puts the object at the start, so the hand is taken to the place after that.
void AssistController::startByHand() {
  bench_.document.whenArranged([this] {
    const HelpPlacesPtr places = places_;
    const std::size_t chosen = chosen_;
    bench_.session.post(command::Stop{});
    if (!isPerson(bench_.session.deviceId())) bench_.session.setDevice(kAnyDevice);
    if (!followsHand(bench_.document.settings().strategy)) bench_.session.post(command::SetPlanner{"by-hand"});
    places_ = places;  // changing the device ended the session, which cleared places_
    chosen_ = chosen;
    starting_ = true;
    bench_.session.post(command::Start{});
  });
}

void AssistController::takeHand() {
  offers_.cancel();
  guide_.reset();
  taken_ = true;
  bench_.session.post(command::SetDevicePose{(*places_)[chosen_].fromStart});
  bench_.scene.view().setPlaybackPose(std::nullopt);
  draw();
  look();
  bench_.scene.widget()->setFocus();
}

void AssistController::look() {
  const HelpPlace& place = (*places_)[chosen_];
  Box3 box;
  for (const Pose& q : {place.fromStart, place.narrowest, place.fromGoal}) {
    box.extend(boundingBox(*bench_.document.scenario()->object.mesh, q));
  }
  bench_.scene.view().camera().zoomTo(box, hint_.coveredShare());
  bench_.scene.refresh();
  emit cameraMoved();
}

void AssistController::draw() {
  bench_.scene.view().setHelp({places_, chosen_, taken_});
  hint_.ask(places_ ? hintText() : QString());
  lead();
  bench_.scene.refresh();
}

/// Shows the next motion of a hand that was taken to a place whose passage is known.
void AssistController::lead() {
  std::optional<Pose> ahead;
  std::vector<KeyToHold> keys;
  if (places_ && taken_ && (*places_)[chosen_].lacking) {
    const CollisionWorld& world = *bench_.document.scenario()->problem.world;
    const double radius = world.objectRadius();
    if (!sight_) sight_ = pointWorld(world)->makeQuery();
    if (!guide_) guide_.emplace((*places_)[chosen_].passage, Se3Metric(radius), kAheadOnPassage * radius);
    const Pose& q = bench_.session.snapshot()->device.q_device;
    ahead = guide_->lead(q, *sight_, object());
    const DeviceShaping shaping = bench_.session.hand()->keyboard.shaping.get();
    if (ahead) keys = keysToHold(q, *ahead, shaping, bench_.session.operatorFrame(), radius);
  }
  bench_.scene.view().setHelpLead(ahead);
  hint_.lead(keys);
}

CollisionQuery& AssistController::object() {
  if (!object_) object_ = bench_.document.scenario()->problem.world->makeQuery();
  return *object_;
}

/// Says it when an obstacle stops the object, with the moves that are free. Offscreen each snapshot counts as a second.
void AssistController::noticeStop() {
  if (!bench_.run.snapshot()) return;
  const SessionSnapshot& now = *bench_.run.snapshot();
  const LoadedScenario& scenario = *bench_.document.scenario();
  const double radius = scenario.problem.world->objectRadius();
  const bool isLockstep = bench_.session.clock() == SessionClock::Lockstep;
  const double time = isLockstep ? 1000.0 * static_cast<double>(now.revision) : static_cast<double>(clock_.elapsed());
  const OperatorSample& hand = now.device;
  const bool isLed = bench_.run.isLive() && isPerson(bench_.session.deviceId()) && hand.nearest.body >= 0;
  if (isLed && stopped_.note(hand, radius, time)) {
    const DeviceShaping shaping = bench_.session.hand()->keyboard.shaping.get();
    const RigidBody& body = scenario.obstacles[static_cast<std::size_t>(hand.nearest.body)];
    hint_.stop(QString::fromStdString(body.shown()),
               freeMoves(hand.q_device, shaping, bench_.session.operatorFrame(), object(), radius));
  } else {
    hint_.stop({}, {});
    if (isLed && hand.hand && !isLockstep) lead_.start();  // no snapshot comes while the object rests
  }
}

QString AssistController::hintText() const {
  const HelpPlace& place = (*places_)[chosen_];
  const LoadedScenario& scenario = *bench_.document.scenario();
  const QString which = tr("Place to help %1 of %2:").arg(chosen_ + 1).arg(places_->size());
  const QString body = place.body < 0
                           ? QString()
                           : QString::fromStdString(scenario.obstacles[static_cast<std::size_t>(place.body)].shown());
  QString lack = body.isEmpty() ? tr("the computer has not found a way through yet.")
                                : tr("%1 is in the way, and the computer has not found a way past it yet.").arg(body);
  if (isOpen(place, scenario.problem.world->objectRadius())) {
    lack = tr("the passage is open.");
  } else if (place.lacking && !body.isEmpty()) {
    lack = tr("needs up to %1 more room at %2.").arg(lengthText(*place.lacking), body);
  } else if (place.lacking) {
    lack = tr("needs up to %1 more room.").arg(lengthText(*place.lacking));
  }
  const QString key = keyOf("assist.go", bench_);
  QString next = tr("%1 takes your hand there.").arg(key);
  if (taken_) next = (place.lacking ? tr("Lead it along the arrow; %1: next place.") : tr("%1: next place.")).arg(key);
  return which + QLatin1Char(' ') + lack + QLatin1Char(' ') + next;
}

void AssistController::addCommands() {
  bench_.scripts.add("expect-help", 2, [this](const ScriptCommands::Words& words) -> Outcome {
    const auto count = toNumber(words[1]);
    if (!count || (words[0] != "places" && words[0] != "taken")) {
      return wrongCommand("expect-help needs 'places' or 'taken' and a number");
    }
    const std::size_t found = words[0] == "places" ? (places_ ? places_->size() : 0) : (taken_ ? chosen_ + 1 : 0);
    if (static_cast<double>(found) == *count) return Done{};
    return unmetExpectation(words[0] + " is " + std::to_string(found));
  });
}

}  // namespace glissade
