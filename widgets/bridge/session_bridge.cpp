#include "widgets/bridge/session_bridge.h"

#include "engine/operator/device_registry.h"

namespace glissade {
namespace {

/// A fixed run on screen: 250 planner steps a second, some six times the operator's own time.
constexpr int kPaceMilliseconds = 16;
constexpr std::uint64_t kStepsAtOnce = 4;

}  // namespace

SessionBridge::SessionBridge(SessionClock clock, QObject* parent)
    : QObject(parent),
      clock_(clock),
      deviceId_("hand"),
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
  scene_ = scenario->problem.scene;
  kept_.clear();
  restart(scenario->parameters, scenario->scenario.seed, scenario->scenario.planner);
}

namespace {

/// Values that somebody chose, for an object of another size; the rest fits itself to it.
ParameterValues carriedOver(const ParameterValues& values, double objectRadius) {
  const ParameterValues usual(values.objectRadius());
  ParameterValues carried(objectRadius);
  for (const ParameterSpec& spec : parameterTable()) {
    // What is out of range for this object goes back to what is usual for it.
    if (values[spec.id] != usual[spec.id]) (void)carried.set(spec.id, values[spec.id]);
  }
  return carried;
}

}  // namespace

void SessionBridge::rearrange(const ScenarioPtr& scenario) {
  const SnapshotPtr last = session_->snapshot();
  keepPath(*last);
  scenario_ = scenario;
  scene_ = scenario->problem.scene;
  restart(carriedOver(last->parameters, scenario->problem.world->objectRadius()), last->seed, last->plannerId);
}

void SessionBridge::setDevice(const std::string& deviceId) {
  if (deviceId == deviceId_ && !fixed_) return;
  deviceId_ = deviceId;
  if (!session_) return;
  keepPath(*session_->snapshot());
  restartAsItIs();
}

void SessionBridge::givePath(command::ExaminePath path) {
  kept_[scenario_->object.id] = std::move(path);
  restartAsItIs();
}

void SessionBridge::restartAsItIs() {
  const SnapshotPtr last = session_->snapshot();
  restart(last->parameters, last->seed, last->plannerId);
}

/// One that is still being examined is kept already.
void SessionBridge::keepPath(const SessionSnapshot& snapshot) {
  const Path* path = snapshot.path ? snapshot.path.get() : snapshot.refused ? &snapshot.refused->path : nullptr;
  if (path != nullptr && !fixed_) kept_[scenario_->object.id] = {path->points, snapshot.provenance};
}

void SessionBridge::restart(const ParameterValues& parameters, std::uint64_t seed, const std::string& planner) {
  end();
  Problem problem = scenario_->problem;
  problem.scene = scene_;
  begin({std::move(problem), parameters, planner, seed, makeDevice(deviceId_, seed)}, clock_);
  session_->setOperatorFrame(frame_);
  emitSnapshot();
  const auto kept = kept_.find(scenario_->object.id);
  if (kept != kept_.end()) post(kept->second);
}

void SessionBridge::startFixed(const FixedRun& run) {
  end();
  fixed_ = true;
  fixedDeviceId_ = run.deviceId;
  begin({scenario_->problem, run.parameters, run.planner, run.seed, makeDevice(run.deviceId, run.seed)},
        SessionClock::Lockstep);
  post(command::Start{});
  if (clock_ == SessionClock::RealTime) pace_.start();
}

/// Before a new session begins.
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
  DeviceContext context{scenario_->scenario.wayPoints,
                        scenario_->problem.metric(),
                        seed,
                        hand_,
                        scenario_->problem.world,
                        !fixed_ && clock_ == SessionClock::RealTime};
  if (const Pose* goal = std::get_if<Pose>(&scenario_->problem.goal)) context.route.push_back(*goal);
  return entry->make(context);
}

void SessionBridge::begin(SessionConfig config, SessionClock clock) {
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
  if (const auto* semantics = std::get_if<command::SetSemantics>(&command)) scene_.edits = semantics->edits;
  if (const auto* known = std::get_if<command::SetKnowledge>(&command)) scene_.knowledge = known->knowledge;
  if (std::holds_alternative<command::Start>(command)) kept_.erase(scenario_->object.id);
  if (session_) session_->post(std::move(command));
  // In lockstep commands are carried out at once; in real time the planner thread does it.
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
