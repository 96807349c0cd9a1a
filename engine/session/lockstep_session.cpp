#include <utility>
#include <vector>

#include "engine/planning/coarse/coarse_plan_report.h"
#include "engine/session/guidance_target.h"
#include "engine/session/operator_hand.h"
#include "engine/session/session_core.h"
#include "engine/session/session_with_planners.h"
#include "engine/session/start_tree_distance.h"

namespace glissade {
namespace {

/// One thread, one clock: every planner step is 1 / steps_per_second of the operator's time.
class Lockstep final : public LockstepSession {
 public:
  Lockstep(SessionConfig config, std::unique_ptr<OperatorDevice> device, PlannerRegistry planners)
      : core_(std::move(config), std::move(planners)),
        hand_(core_.problem(), std::move(device)),
        tree_(core_.problem().metric()) {
    unpublished_->state = SessionState::Failed;
    unpublished_->problem = withoutMemory();
    publish();
  }

  void post(Command command) override { commands_.push_back(std::move(command)); }
  void setOperatorFrame(const OperatorFrame& frame) override { frame_ = frame; }
  SnapshotPtr snapshot() const override { return snapshot_; }
  void setWakeUp(std::function<void()> wakeUp) override { wakeUp_ = std::move(wakeUp); }

  void advance(std::uint64_t steps, const StopToken& stop) override {
    carryOutCommands();
    if (core_.state() == SessionState::Planning) {
      core_.attempt(GLISSADE_TEXT("planning"), [&] { plan(steps, stop); });
    } else if (core_.state() == SessionState::Paused) {
      guardHand([this] { hand_.rest(); });
    } else {
      for (std::uint64_t i = 0; i < steps; ++i) tick();
    }
    if (!core_.publish([this] { publish(); })) publishWithoutMemory();
    if (wakeUp_) wakeUp_();
  }

 private:
  void carryOutCommands() {
    for (const Command& command : std::exchange(commands_, {})) {
      if (const auto* put = std::get_if<command::SetDevicePose>(&command)) hand_.put(put->q_device);
      const std::uint64_t runBefore = core_.run();
      core_.attempt(workOf(command), [&] { core_.carryOut(command); });
      if (core_.run() != runBefore) {
        deviceProblem_.reset();
        tree_.reset();
        guardHand([this] { hand_.restart(); });
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
    guardHand([this] {
      if (core_.planner() != nullptr) tree_.update(core_.planner()->nodes());
      hand_.advance(secondsPerStep(), frame_, tree_, guidance());
    });
  }

  template <class Work>
  void guardHand(const Work& work) {
    if (auto why = guarded(OperatorHand::kWork, work)) deviceProblem_ = hand_.giveUp(std::move(*why));
  }

  Guidance guidance() {
    const Planner* planner = core_.planner();
    const CoarsePlanPtr plan = planner != nullptr ? coarsePlanOf(*planner) : nullptr;
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
    if (deviceProblem_) next->problem = deviceProblem_;
    snapshot_ = std::move(next);
  }

  /// Publishes the end of the run even if no memory is left to describe it.
  void publishWithoutMemory() {
    unpublished_->run = core_.run();
    unpublished_->revision = ++revision_;
    snapshot_ = unpublished_;
  }

  double secondsPerStep() const { return 1.0 / core_.parameters()[ParameterId::StepsPerSecond]; }

  SessionCore core_;
  OperatorHand hand_;
  StartTreeDistance tree_;
  OperatorFrame frame_;
  std::optional<Diagnostic> deviceProblem_;
  std::vector<Command> commands_;
  std::function<void()> wakeUp_;
  std::uint64_t revision_ = 0;
  SnapshotPtr snapshot_;
  std::shared_ptr<SessionSnapshot> unpublished_ = std::make_shared<SessionSnapshot>();  ///< replaces the snapshot
};

}  // namespace

std::unique_ptr<LockstepSession> makeLockstepSession(SessionConfig config) {
  return makeLockstepSession(std::move(config), makePlannerRegistry());
}

std::unique_ptr<LockstepSession> makeLockstepSession(SessionConfig config, PlannerRegistry planners) {
  auto device = std::move(config.device);
  return std::make_unique<Lockstep>(std::move(config), std::move(device), std::move(planners));
}

}  // namespace glissade
