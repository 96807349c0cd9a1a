#include "widgets/bridge/session_bridge.h"

#include "engine/operator/device_registry.h"

namespace glissade {

SessionBridge::SessionBridge(SessionClock clock, QObject* parent)
    : QObject(parent),
      clock_(clock),
      deviceId_("hand"),
      hand_(clock == SessionClock::RealTime ? std::make_shared<HandInputs>()
                                            : std::make_shared<HandInputs>(std::nullopt)) {
  qRegisterMetaType<SnapshotPtr>();
}

SessionBridge::~SessionBridge() {
  if (session_) session_->setWakeUp({});
}

void SessionBridge::open(const ScenarioPtr& scenario) {
  scenario_ = scenario;
  scene_ = scenario->problem.scene;
  restart(scenario->parameters, scenario->scenario.seed, scenario->scenario.planner);
}

void SessionBridge::setDevice(const std::string& deviceId) {
  if (deviceId == deviceId_) return;
  deviceId_ = deviceId;
  if (!session_) return;
  const SnapshotPtr last = session_->snapshot();
  restart(last->parameters, last->seed, last->plannerId);
}

void SessionBridge::restart(const ParameterValues& parameters, std::uint64_t seed, const std::string& planner) {
  if (session_) session_->setWakeUp({});
  lockstep_ = nullptr;
  session_.reset();
  const DeviceRegistry registry = makeDeviceRegistry();
  DeviceContext context{scenario_->scenario.wayPoints, scenario_->problem.metric(),     seed, hand_,
                        scenario_->problem.world,      clock_ == SessionClock::RealTime};
  if (const Pose* goal = std::get_if<Pose>(&scenario_->problem.goal)) context.route.push_back(*goal);
  Problem problem = scenario_->problem;
  problem.scene = scene_;
  SessionConfig config{std::move(problem), parameters, planner, seed, registry.find(deviceId_)->make(context)};
  if (clock_ == SessionClock::Lockstep) {
    auto lockstep = makeLockstepSession(std::move(config));
    lockstep_ = lockstep.get();
    session_ = std::move(lockstep);
  } else {
    session_ = makeThreadedSession(std::move(config));
  }
  session_->setOperatorFrame(frame_);
  session_->setWakeUp([this] {
    QMetaObject::invokeMethod(
        this, [this] { emitSnapshot(); }, Qt::QueuedConnection);
  });
  emitSnapshot();
}

void SessionBridge::post(Command command) {
  if (const auto* semantics = std::get_if<command::SetSemantics>(&command)) scene_.edits = semantics->edits;
  if (const auto* known = std::get_if<command::SetKnowledge>(&command)) scene_.knowledge = known->knowledge;
  if (session_) session_->post(std::move(command));
  // In lockstep commands are carried out at once; in real time the planner thread does it.
  advance(0);
}

void SessionBridge::setOperatorFrame(const OperatorFrame& frame) {
  frame_ = frame;
  if (session_) session_->setOperatorFrame(frame);
}

SnapshotPtr SessionBridge::snapshot() const { return session_ ? session_->snapshot() : nullptr; }

void SessionBridge::advance(std::uint64_t steps) {
  if (lockstep_ == nullptr) return;
  lockstep_->advance(steps);
  emitSnapshot();
}

void SessionBridge::emitSnapshot() {
  if (session_) emit snapshotChanged(session_->snapshot());
}

}  // namespace glissade
