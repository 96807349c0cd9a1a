#include "widgets/document/session_bridge.h"

#include <utility>

#include "engine/base/guarded.h"
#include "engine/files/same_problem.h"
#include "engine/files/scenario_bodies.h"
#include "engine/operator/device_registry.h"

namespace glissade {
namespace {

/// Pace of a fixed run on screen: 250 planner steps a second, some six times the operator's own time.
constexpr int kPaceMilliseconds = 16;
constexpr std::uint64_t kStepsAtOnce = 4;
/// The work that an exception is said to have interrupted.
constexpr CatalogueText kBeginning = GLISSADE_TEXT("preparing the planner");

}  // namespace

SessionBridge::SessionBridge(SessionClock clock, QObject* parent)
    : QObject(parent),
      clock_(clock),
      deviceId_(kAnyDevice),
      hand_(clock == SessionClock::RealTime ? std::make_shared<HandInputs>()
                                            : std::make_shared<HandInputs>(std::nullopt)) {
  qRegisterMetaType<SnapshotPtr>();
  pace_.setInterval(kPaceMilliseconds);
  connect(&pace_, &QTimer::timeout, this, [this] { advance(kStepsAtOnce); });
}

SessionBridge::~SessionBridge() {
  if (session_) session_->setWakeUp({});
}

void SessionBridge::open(const ScenarioPtr& scenario) {
  scenario_ = scenario;
  edits_ = scenario->problem.scene.edits;
  knowledge_ = scenario->problem.scene.knowledge;
  beginAnew([&] {
    kept_.clear();
    settings_ = {scenario->parameters, scenario->scenario.seed, scenario->scenario.planner};
  });
}

namespace {

/// Values that a person has set, for an object of another size; the other values follow that size.
ParameterValues carriedOver(const ParameterValues& values, double objectRadius) {
  const ParameterValues usual(values.objectRadius());
  ParameterValues carried(objectRadius);
  for (const ParameterSpec& spec : parameterTable()) {
    // A value that is out of range for this object falls back to its default.
    if (values[spec.id] != usual[spec.id]) (void)carried.set(spec.id, values[spec.id]);
  }
  return carried;
}

}  // namespace

void SessionBridge::rearrange(const ScenarioPtr& scenario) {
  const ScenarioPtr before = std::exchange(scenario_, scenario);
  const SemanticEditsPtr edits = std::exchange(edits_, scenario->problem.scene.edits);
  if (session_ && !fixed_ && !forgets_ && *edits == *edits_ && isSameProblem(*before, *scenario)) {
    post(command::SetNames{scenario->problem.world});
    emitSnapshot();  // observers show none of an earlier arrangement
    return;
  }
  knowledge_ = scenario->problem.scene.knowledge;
  beginAnew([&] {
    keepPath(idOf(before->scenario.object));
    takeSettings();
    settings_.parameters = carriedOver(settings_.parameters, scenario->problem.world->objectRadius());
  });
}

void SessionBridge::setDevice(const std::string& deviceId) {
  if (deviceId == deviceId_ && !fixed_) return;
  deviceId_ = deviceId;
  if (scenario_) restart();
}

void SessionBridge::givePath(command::ExaminePath path) {
  beginAnew([&] {
    takeSettings();
    kept_[idOf(scenario_->scenario.object)] = std::move(path);
  });
}

/// Begins a new session on the same scenario, with the present path.
void SessionBridge::restart() {
  beginAnew([this] {
    keepPath(idOf(scenario_->scenario.object));
    takeSettings();
  });
}

/// Takes the settings of the last session. If that could not be made, the settings from before it stay.
void SessionBridge::takeSettings() {
  if (!session_) return;
  const SnapshotPtr last = session_->snapshot();
  settings_ = {last->parameters, last->seed, last->plannerId};
}

/// Keeps the path for the next session. A path that is still being examined has been kept already.
void SessionBridge::keepPath(const std::string& objectId) {
  const bool forgets = std::exchange(forgets_, false);
  if (!session_ || fixed_) return;
  if (forgets) {
    kept_.erase(objectId);
    return;
  }
  const SnapshotPtr last = session_->snapshot();
  const Path* path = last->path ? last->path.get() : last->refused ? &last->refused->path : nullptr;
  if (path != nullptr) kept_[objectId] = {path->points, last->provenance};
}

/// Ends the session and begins another. `prepare` takes the data from the old one that the new one needs.
template <class Prepare>
void SessionBridge::beginAnew(const Prepare& prepare) {
  const auto why = guarded(kBeginning, [&] {
    prepare();
    end();
    Problem problem = scenario_->problem;
    problem.scene.edits = edits_;
    problem.scene.knowledge = knowledge_;
    begin({std::move(problem), settings_.parameters, settings_.planner, settings_.seed,
           makeDevice(deviceId_, settings_.seed)},
          clock_);
    session_->setOperatorFrame(frame_);
  });
  if (why) {
    fail(*why);
    return;
  }
  emitSnapshot();
  const auto kept = kept_.find(idOf(scenario_->scenario.object));
  if (kept != kept_.end()) post(kept->second);
}

/// Leaves no session; the snapshot states the reason.
void SessionBridge::fail(const Diagnostic& why) {
  end();
  auto snapshot = std::make_shared<SessionSnapshot>();
  snapshot->state = SessionState::Failed;
  snapshot->problem = why;
  snapshot->plannerId = settings_.planner;
  snapshot->seed = settings_.seed;
  snapshot->parameters = settings_.parameters;
  snapshot->device.q_device = scenario_->problem.start;
  announced_ = std::move(snapshot);
  emit snapshotChanged(SnapshotPtr(announced_));
}

void SessionBridge::startFixed(const FixedRun& run) {
  const auto why = guarded(kBeginning, [&] {
    end();
    fixed_ = true;
    fixedDeviceId_ = run.deviceId;
    begin({scenario_->problem, run.parameters, run.planner, run.seed, makeDevice(run.deviceId, run.seed)},
          SessionClock::Lockstep);
  });
  if (why) {
    fail(*why);
    return;
  }
  post(command::Start{});
  if (clock_ == SessionClock::RealTime) pace_.start();
}

/// Ends the session, before a new one begins.
void SessionBridge::end() {
  if (session_) session_->setWakeUp({});
  pace_.stop();
  fixed_ = false;
  lockstep_ = nullptr;
  session_.reset();
  announced_.reset();
}

std::unique_ptr<OperatorDevice> SessionBridge::makeDevice(const std::string& id, std::uint64_t seed) {
  const DeviceRegistry registry = makeDeviceRegistry();
  const DeviceEntry* entry = registry.find(id);
  if (entry == nullptr) return nullptr;
  return entry->make({routeOf(*scenario_), scenario_->problem.metric(), seed, hand_, scenario_->problem.world,
                      !fixed_ && clock_ == SessionClock::RealTime});
}

void SessionBridge::begin(SessionConfig config, SessionClock clock) {
  startedRun_ = 0;
  if (clock == SessionClock::Lockstep) {
    auto lockstep = makeLockstepSession(std::move(config));
    lockstep_ = lockstep.get();
    session_ = std::move(lockstep);
  } else {
    session_ = makeThreadedSession(std::move(config));
  }
  session_->setWakeUp([this] {
    QMetaObject::invokeMethod(
        this, [this] { emitSnapshot(); }, Qt::QueuedConnection);
  });
}

void SessionBridge::post(Command command) {
  if (const auto* semantics = std::get_if<command::SetSemantics>(&command)) edits_ = semantics->edits;
  if (const auto* known = std::get_if<command::SetKnowledge>(&command)) knowledge_ = known->knowledge;
  if (scenario_ && !session_) restart();  // it could not be made before
  if (!session_) return;
  if (std::holds_alternative<command::Start>(command)) {
    kept_.erase(idOf(scenario_->scenario.object));
    startedRun_ = announced_ ? announced_->run + 1 : 1;
  }
  session_->post(std::move(command));
  // Commands are carried out at once in lockstep; in real time the planner thread carries them out.
  advance(0);
}

void SessionBridge::setOperatorFrame(const OperatorFrame& frame) {
  frame_ = frame;
  if (session_ && !fixed_) session_->setOperatorFrame(frame);
}

void SessionBridge::advance(std::uint64_t steps) {
  if (lockstep_ == nullptr) return;
  lockstep_->advance(steps);
  emitSnapshot();
}

void SessionBridge::emitSnapshot() {
  if (!session_) return;
  announced_ = session_->snapshot();
  emit snapshotChanged(SnapshotPtr(announced_));
}

}  // namespace glissade
