#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "engine/session/guidance_target.h"
#include "engine/session/operator_hand.h"
#include "engine/session/session_core.h"
#include "engine/session/start_tree_distance.h"

namespace glissade {
namespace {

using Clock = std::chrono::steady_clock;

/// The operator thread's pace: that of a 6D mouse (125 Hz).
constexpr std::chrono::milliseconds kOperatorTick{8};
/// No operator's time passes faster than this in one tick, however late the thread is.
constexpr double kLongestTick = 0.05;
/// The window is woken, and the roadmap published, at most this often.
constexpr std::chrono::milliseconds kPublishInterval{16};

/// The planner thread owns the core, the operator thread owns the hand; between them and the window
/// lie a command queue, a mailbox each way, and the parts that a snapshot is put together from.
class Threaded final : public Session {
 public:
  explicit Threaded(SessionConfig config)
      : core_(config.problem, config.parameters, config.plannerId, config.seed),
        hand_(config.problem, std::move(config.device)),
        tree_(config.problem.metric()) {
    core_.describe(planning_);
    operatorSample_ = hand_.sample();
    held_ = hand_.held();
    operatorThread_ = std::thread([this] { operatorLoop(); });
    plannerThread_ = std::thread([this] { plannerLoop(); });
  }

  ~Threaded() override {
    {
      const std::lock_guard lock(mutex_);
      quit_ = true;
      stop_.requestStop();
    }
    commandsArrived_.notify_all();
    plannerThread_.join();
    operatorThread_.join();
  }

  void post(Command command) override {
    {
      const std::lock_guard lock(mutex_);
      if (const auto* put = std::get_if<command::SetDevicePose>(&command)) {
        putWanted_ = put->q_device;
        return;
      }
      if (std::holds_alternative<command::Stop>(command)) stop_.requestStop();
      commands_.push_back(std::move(command));
    }
    commandsArrived_.notify_all();
  }

  void setOperatorFrame(const OperatorFrame& frame) override {
    const std::lock_guard lock(mutex_);
    frame_ = frame;
  }

  void setWakeUp(std::function<void()> wakeUp) override {
    const std::lock_guard lock(wakeUpMutex_);
    wakeUp_ = std::move(wakeUp);
  }

  SnapshotPtr snapshot() const override {
    const std::lock_guard lock(mutex_);
    wakeUpPending_ = false;
    if (dirty_ || !snapshot_) {
      dirty_ = false;
      auto next = std::make_shared<SessionSnapshot>(planning_);
      next->revision = ++revision_;
      next->virtualSeconds = next->planningSeconds;
      next->device = operatorSample_;
      next->deviceConnected = deviceConnected_;
      if (operatorTrouble_) next->problem = operatorTrouble_;
      snapshot_ = std::move(next);
    }
    return snapshot_;
  }

 private:
  // ---- planner thread ----

  void plannerLoop() {
    while (waitForWork()) {
      if (core_.state() == SessionState::Planning) {
        SessionCore::Hooks hooks;
        hooks.hand = [this] { return readOperator(); };
        hooks.operatorSample = [this] { return operatorSeen_; };
        hooks.seconds = [this] { return core_.planningSeconds(); };
        hooks.afterStep = [this] { return afterStep(); };
        hooks.stop = freshStopToken();
        core_.plan(hooks);
      }
      publishPlanning();
    }
  }

  /// Carries out what was asked for; sleeps while there is nothing to do. False: the session ends.
  bool waitForWork() {
    std::deque<Command> commands;
    {
      std::unique_lock lock(mutex_);
      commandsArrived_.wait(lock,
                            [this] { return quit_ || !commands_.empty() || core_.state() == SessionState::Planning; });
      if (quit_) return false;
      commands.swap(commands_);
    }
    for (const Command& command : commands) {
      const std::uint64_t runBefore = core_.run();
      if (std::holds_alternative<command::SmoothPath>(command)) {
        work(command, PathWork::Kind::Smoothing);
      } else if (std::holds_alternative<command::ExaminePath>(command)) {
        work(command, PathWork::Kind::Examination);
      } else {
        core_.carryOut(command);
      }
      if (core_.run() == runBefore) continue;
      const std::lock_guard lock(mutex_);
      restartWanted_ = true;
      chunks_.clear();
    }
    return true;
  }

  /// Publishes how far it is.
  void work(const Command& command, PathWork::Kind kind) {
    const auto report = [this, kind](double share) {
      if (Clock::now() - lastPublication_ >= kPublishInterval) publishPlanning(PathWork{kind, share});
    };
    core_.carryOut(command, WorkWatch(freshStopToken(), report));
  }

  /// A stop that is asked for from now on, or that waits in the queue already. Other commands let the
  /// planner finish its step: a step cut off could not be replayed.
  StopToken freshStopToken() {
    const std::lock_guard lock(mutex_);
    stop_ = StopSource();
    const bool stopQueued = std::any_of(commands_.begin(), commands_.end(), [](const Command& command) {
      return std::holds_alternative<command::Stop>(command);
    });
    if (quit_ || stopQueued) stop_.requestStop();
    return stop_.token();
  }

  /// What the planner sees of the operator for one step.
  std::optional<HandState> readOperator() {
    const std::lock_guard lock(mutex_);
    if (!held_) return std::nullopt;
    operatorSeen_ = operatorSample_;
    return HandState{operatorSeen_.q_device, operatorSeen_.moves};
  }

  bool afterStep() {
    if (Clock::now() - lastPublication_ >= kPublishInterval) publishPlanning();
    const std::lock_guard lock(mutex_);
    return !quit_ && commands_.empty();
  }

  void publishPlanning(std::optional<PathWork> work = std::nullopt) {
    SessionSnapshot next;
    core_.describe(next);
    next.pathWork = work;
    lastPublication_ = Clock::now();
    const std::lock_guard lock(mutex_);
    chunks_ = next.roadmap;
    planning_ = std::move(next);
    dirty_ = true;
  }

  // ---- operator thread ----

  /// What the operator sees of the planning.
  struct Sight {
    RoadmapChunks chunks;
    ParameterValues parameters{1.0};
    std::shared_ptr<const Path> path;
    CoarsePlanPtr coarsePlan;
  };

  void operatorLoop() {
    auto last = Clock::now();
    while (operatorTick(std::min(kLongestTick, std::chrono::duration<double>(Clock::now() - last).count()), last)) {
      wakeWindow();
      std::this_thread::sleep_until(last + kOperatorTick);
    }
  }

  bool operatorTick(double dt, Clock::time_point& last) {
    last = Clock::now();
    OperatorFrame frame;
    std::optional<Pose> put;
    bool restart = false;
    Sight sight;
    {
      const std::lock_guard lock(mutex_);
      if (quit_) return false;
      frame = frame_;
      put = std::exchange(putWanted_, std::nullopt);
      restart = std::exchange(restartWanted_, false);
      sight = {chunks_, planning_.parameters, planning_.path, planning_.coarsePlan};
    }
    try {
      moveHand(dt, frame, put, restart, sight);
    } catch (const std::exception& error) {
      hand_.release();
      const std::lock_guard lock(mutex_);
      operatorTrouble_ = Diagnostic{ErrorKind::Internal, "", "device",
                                    std::string("the device failed: ") + error.what(), "Choose a device again."};
    }
    publishOperator();
    return true;
  }

  void moveHand(double dt, const OperatorFrame& frame, const std::optional<Pose>& put, bool restart,
                const Sight& sight) {
    if (restart) {
      tree_.reset();
      hand_.restart();
    }
    if (put) hand_.put(*put);
    tree_.update(sight.chunks);
    const Se3Metric metric(sight.parameters.objectRadius());
    const auto target = guidanceTarget(sight.path.get(), sight.coarsePlan.get(), hand_.q_device(), metric);
    hand_.advance(dt, frame, tree_, guidanceOf(sight.parameters, target));
  }

  void publishOperator() {
    const OperatorSample& sample = hand_.sample();
    const std::lock_guard lock(mutex_);
    if (sample.moves != operatorSample_.moves || sample.guidance != operatorSample_.guidance ||
        deviceConnected_ != hand_.connected() || held_ != hand_.held()) {
      dirty_ = true;
    }
    operatorSample_ = sample;
    deviceConnected_ = hand_.connected();
    held_ = hand_.held();
  }

  /// At most one wake-up is pending and at most one comes in a publishing interval.
  void wakeWindow() {
    const std::lock_guard wakeUpLock(wakeUpMutex_);
    if (!wakeUp_) return;
    {
      const auto now = Clock::now();
      const std::lock_guard lock(mutex_);
      if (!dirty_ || wakeUpPending_ || now - lastWakeUp_ < kPublishInterval) return;
      wakeUpPending_ = true;
      lastWakeUp_ = now;
    }
    wakeUp_();
  }

  SessionCore core_;                   ///< planner thread
  OperatorHand hand_;                  ///< operator thread
  StartTreeDistance tree_;             ///< operator thread
  OperatorSample operatorSeen_;        ///< planner thread: what the planner sees in this step
  Clock::time_point lastPublication_;  ///< planner thread

  mutable std::mutex mutex_;  ///< guards everything below up to the threads
  std::condition_variable commandsArrived_;
  std::deque<Command> commands_;
  bool quit_ = false;
  StopSource stop_;
  SessionSnapshot planning_;
  OperatorFrame frame_;
  std::optional<Pose> putWanted_;
  bool restartWanted_ = false;
  RoadmapChunks chunks_;  ///< for the operator to see
  OperatorSample operatorSample_;
  bool held_ = false;
  bool deviceConnected_ = true;
  std::optional<Diagnostic> operatorTrouble_;
  mutable bool dirty_ = true;
  mutable bool wakeUpPending_ = false;
  mutable std::uint64_t revision_ = 0;
  mutable SnapshotPtr snapshot_;
  Clock::time_point lastWakeUp_;

  std::mutex wakeUpMutex_;  ///< held while the window is woken: setWakeUp({}) returns after the last call
  std::function<void()> wakeUp_;

  std::thread operatorThread_;
  std::thread plannerThread_;
};

}  // namespace

std::unique_ptr<Session> makeThreadedSession(SessionConfig config) {
  return std::make_unique<Threaded>(std::move(config));
}

}  // namespace glissade
