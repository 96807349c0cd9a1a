#include <utility>
#include <vector>

#include "engine/session/guidance_target.h"
#include "engine/session/operator_hand.h"
#include "engine/session/session_core.h"
#include "engine/session/start_tree_distance.h"

namespace glissade {
namespace {

/// One thread, one clock: every planner step is 1 / steps_per_second of the operator's time.
class Lockstep final : public LockstepSession {
 public:
  explicit Lockstep(SessionConfig config)
      : core_(config.problem, config.parameters, config.plannerId, config.seed),
        hand_(config.problem, std::move(config.device)),
        tree_(config.problem.metric()) {
    publish();
  }

  void post(Command command) override { commands_.push_back(std::move(command)); }
  void setOperatorFrame(const OperatorFrame& frame) override { frame_ = frame; }
  SnapshotPtr snapshot() const override { return snapshot_; }
  void setWakeUp(std::function<void()> wakeUp) override { wakeUp_ = std::move(wakeUp); }

  void advance(std::uint64_t steps, const StopToken& stop) override {
    carryOutCommands();
    if (core_.state() == SessionState::Planning) {
      plan(steps, stop);
    } else if (core_.state() != SessionState::Paused) {
      for (std::uint64_t i = 0; i < steps; ++i) tick();
    }
    publish();
    if (wakeUp_) wakeUp_();
  }

 private:
  void carryOutCommands() {
    for (const Command& command : std::exchange(commands_, {})) {
      if (const auto* put = std::get_if<command::SetDevicePose>(&command)) hand_.put(put->q_device);
      const std::uint64_t runBefore = core_.run();
      core_.carryOut(command);
      if (core_.run() != runBefore) {
        tree_.reset();
        hand_.restart();
      }
    }
  }

  void plan(std::uint64_t steps, const StopToken& stop) {
    std::uint64_t left = steps;
    SessionCore::Hooks hooks;
    hooks.hand = [this] { return hand_.state(); };
    hooks.operatorSample = [this] { return hand_.sample(); };
    hooks.seconds = [this] { return static_cast<double>(core_.steps()) * secondsPerStep(); };
    hooks.afterStep = [this, &left, &stop] {
      tick();
      return --left > 0 && !stop.stopRequested();
    };
    hooks.stop = stop;
    if (steps > 0) core_.plan(hooks);
  }

  void tick() {
    if (core_.planner() != nullptr) tree_.update(core_.planner()->nodes());
    hand_.advance(secondsPerStep(), frame_, tree_, guidance());
  }

  Guidance guidance() {
    const Planner* planner = core_.planner();
    const CoarsePlanPtr plan = planner != nullptr ? planner->coarsePlan() : nullptr;
    return guidanceOf(core_.parameters(),
                      guidanceTarget(core_.path(), plan.get(), hand_.q_device(), core_.problem().metric()));
  }

  void publish() {
    auto next = std::make_shared<SessionSnapshot>();
    core_.describe(*next);
    next->revision = ++revision_;
    next->virtualSeconds = static_cast<double>(next->counts.steps) * secondsPerStep();
    next->device = hand_.sample();
    next->deviceConnected = hand_.connected();
    snapshot_ = std::move(next);
  }

  double secondsPerStep() const { return 1.0 / core_.parameters()[ParameterId::StepsPerSecond]; }

  SessionCore core_;
  OperatorHand hand_;
  StartTreeDistance tree_;
  OperatorFrame frame_;
  std::vector<Command> commands_;
  std::function<void()> wakeUp_;
  std::uint64_t revision_ = 0;
  SnapshotPtr snapshot_;
};

}  // namespace

std::unique_ptr<LockstepSession> makeLockstepSession(SessionConfig config) {
  return std::make_unique<Lockstep>(std::move(config));
}

}  // namespace glissade
