#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

#include "engine/base/guarded.h"
#include "engine/session/guidance_target.h"
#include "engine/session/operator_hand.h"
#include "engine/session/session_core.h"
#include "engine/session/session_with_planners.h"
#include "engine/session/start_tree_distance.h"

namespace glissade {
namespace {

using Clock = std::chrono::steady_clock;

/// Period of the operator thread: that of a 6D mouse (125 Hz).
constexpr std::chrono::milliseconds kOperatorTick{8};
/// Longest operator time of one tick, seconds, even if the thread is late.
constexpr double kLongestTick = 0.05;
/// Least time between two notifications of the window and publications of the roadmap.
constexpr std::chrono::milliseconds kPublishInterval{16};

/// The planner thread owns the core, and the operator thread owns the hand. They communicate with each other and with
/// the window by a command queue, a mailbox in each direction, and the parts of a snapshot.
class Threaded final : public Session {
 public:
  Threaded(SessionConfig config, std::unique_ptr<OperatorDevice> device, PlannerRegistry planners)
      : core_(std::move(config), std::move(planners)),
        hand_(core_.problem(), std::move(device)),
        tree_(core_.problem().metric()) {
    core_.describe(planning_);
    operatorSample_ = hand_.sample();
    held_ = hand_.held();
    try {
      operatorThread_ = std::thread([this] { operatorLoop(); });
      plannerThread_ = std::thread([this] { plannerLoop(); });
    } catch (...) {  // the system provides no more threads
      endThreads();
      throw;
    }
  }

  ~Threaded() override { endThreads(); }

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
    plannerWakes_.notify_all();
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
  void endThreads() {
    {
      const std::lock_guard lock(mutex_);
      quit_ = true;
      stop_.requestStop();
    }
    plannerWakes_.notify_all();
    operatorWakes_.notify_all();
    if (plannerThread_.joinable()) plannerThread_.join();
    if (operatorThread_.joinable()) operatorThread_.join();
  }

  // ---- planner thread ----

  void plannerLoop() {
    while (waitForWork()) {
      while (const auto command = nextCommand()) carryOut(*command);
      if (mayPlan()) core_.attempt(GLISSADE_TEXT("planning"), [this] { plan(); });
      if (!core_.publish([this] { publishPlanning(); })) publishWithoutMemory();
    }
  }

  /// Sleeps while there is nothing to do. False: the session ends.
  bool waitForWork() {
    std::unique_lock lock(mutex_);
    plannerWakes_.wait(lock, [this] {
      return quit_ || !commands_.empty() || (core_.state() == SessionState::Planning && !waitsForHand());
    });
    return !quit_;
  }

  /// Precondition: mutex_ is locked.
  bool waitsForHand() const {
    return withHand_ && core_.state() == SessionState::Planning && core_.steps() == 0 && held_ &&
           core_.parameters()[ParameterId::Alpha] < 1.0 && !(operatorRun_ == run_ && hasHandMoved_);
  }

  bool mayPlan() const {
    const std::lock_guard lock(mutex_);
    return core_.state() == SessionState::Planning && !waitsForHand();
  }

  std::optional<Command> nextCommand() {
    const std::lock_guard lock(mutex_);
    if (quit_ || commands_.empty()) return std::nullopt;
    std::optional<Command> next = std::move(commands_.front());
    commands_.pop_front();
    return next;
  }

  void carryOut(const Command& command) {
    const std::uint64_t runBefore = core_.run();
    if (const auto* start = std::get_if<command::Start>(&command)) withHand_ = start->withHand;
    core_.attempt(workOf(command), [&] {
      if (std::holds_alternative<command::SmoothPath>(command)) {
        work(command, PathWork::Kind::Smoothing);
      } else if (std::holds_alternative<command::ExaminePath>(command)) {
        work(command, PathWork::Kind::Examination);
      } else {
        core_.carryOut(command);
      }
    });
    if (core_.run() == runBefore) return;
    {
      const std::lock_guard lock(mutex_);
      run_ = core_.run();
      operatorTrouble_.reset();
      chunks_.clear();
    }
    operatorWakes_.notify_all();
  }

  void plan() {
    SessionCore::Hooks hooks;
    hooks.hand = [this] { return readOperator(); };
    hooks.operatorSample = [this] { return operatorSeen_; };
    hooks.seconds = [this] { return core_.planningSeconds(); };
    hooks.afterStep = [this] { return afterStep(); };
    hooks.stop = freshStopToken();
    core_.plan(hooks);
  }

  /// Works on a path and publishes the progress.
  void work(const Command& command, PathWork::Kind kind) {
    const auto report = [this, kind](double share) {
      if (Clock::now() - lastPublication_ >= kPublishInterval) publishPlanning(PathWork{kind, share});
    };
    core_.carryOut(command, WorkWatch(freshStopToken(), report));
  }

  /// A token for stops that are requested from now on or already queued. Other commands let the planner finish its
  /// step, because an interrupted step cannot be replayed.
  StopToken freshStopToken() {
    const std::lock_guard lock(mutex_);
    stop_ = StopSource();
    const bool stopQueued = std::any_of(commands_.begin(), commands_.end(), [](const Command& command) {
      return std::holds_alternative<command::Stop>(command);
    });
    if (quit_ || stopQueued) stop_.requestStop();
    return stop_.token();
  }

  /// The operator's state that the planner uses in one step. The first step of a run waits until the hand is back at
  /// the start.
  std::optional<HandState> readOperator() {
    std::unique_lock lock(mutex_);
    plannerWakes_.wait(lock,
                       [this] { return !held_ || operatorRun_ == run_ || quit_ || stop_.token().stopRequested(); });
    if (!held_ || operatorRun_ != run_) return std::nullopt;
    operatorSeen_ = operatorSample_;
    return HandState{operatorSeen_.q_device, operatorSeen_.moves};
  }

  bool afterStep() {
    if (Clock::now() - lastPublication_ >= kPublishInterval) publishPlanning();
    keepPace();
    const std::lock_guard lock(mutex_);
    return !quit_ && commands_.empty();
  }

  /// Sleeps until the next step is due, or a command arrives. Late steps are not caught up.
  void keepPace() {
    const double pace = core_.parameters()[ParameterId::Pace];
    if (pace <= 0.0) return;
    const auto interval = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1.0 / pace));
    const auto due = std::max(lastStep_ + interval, Clock::now() - interval);
    while (Clock::now() < due) {
      publishPlanning();
      const auto until = std::min(due, Clock::now() + kPublishInterval);
      std::unique_lock lock(mutex_);
      if (plannerWakes_.wait_until(lock, until, [this] { return quit_ || !commands_.empty(); })) break;
    }
    lastStep_ = std::min(due, Clock::now());
  }

  void publishPlanning(std::optional<PathWork> work = std::nullopt) {
    SessionSnapshot next;
    core_.describe(next);
    next.pathWork = work;
    lastPublication_ = Clock::now();
    const std::lock_guard lock(mutex_);
    next.waitsForHand = waitsForHand();
    chunks_ = next.roadmap;
    planning_ = std::move(next);
    dirty_ = true;
  }

  /// Publishes the end of the run even if no memory is left to describe it.
  void publishWithoutMemory() {
    const std::lock_guard lock(mutex_);
    planning_.state = core_.state();
    planning_.problem = withoutMemory();
    dirty_ = true;
  }

  // ---- operator thread ----

  /// The planning data that the operator sees.
  struct Sight {
    RoadmapChunks chunks;
    ParameterValues parameters{1.0};
    std::shared_ptr<const Path> path;
    CoarsePlanPtr coarsePlan;
    bool runEnded = false;
    bool paused = false;
  };

  void operatorLoop() {
    auto last = Clock::now();
    for (bool goesOn = true; goesOn; waitForTick(last + kOperatorTick)) {
      const double dt = std::min(kLongestTick, std::chrono::duration<double>(Clock::now() - last).count());
      last = Clock::now();
      auto why = guarded(OperatorHand::kWork, [&] { goesOn = operatorTick(dt); });
      if (why) giveUpDevice(std::move(*why));
      wakeWindow();
    }
  }

  /// Sleeps until the next tick is due, or a run begins.
  void waitForTick(Clock::time_point due) {
    std::unique_lock lock(mutex_);
    operatorWakes_.wait_until(lock, due, [this] { return quit_ || operatorRun_ != run_; });
  }

  /// One tick of the operator. False: the session ends.
  bool operatorTick(double dt) {
    OperatorFrame frame;
    std::optional<Pose> put;
    std::uint64_t run = 0;
    bool restart = false;
    Sight sight;
    {
      const std::lock_guard lock(mutex_);
      if (quit_) return false;
      frame = frame_;
      put = std::exchange(putWanted_, std::nullopt);
      run = run_;
      restart = run != operatorRun_;
      const bool runEnded = planning_.run > 0 && !isRunning(planning_);
      sight = {chunks_,        planning_.parameters,
               planning_.path, planning_.coarsePlan,
               runEnded,       planning_.state == SessionState::Paused};
    }
    moveHand(dt, frame, put, restart, sight);
    publishOperator(run);
    return true;
  }

  void giveUpDevice(Diagnostic why) {
    Diagnostic problem = hand_.giveUp(std::move(why));
    {
      const std::lock_guard lock(mutex_);
      operatorTrouble_ = std::move(problem);
      operatorRun_ = run_;
      held_ = false;
      deviceConnected_ = true;  // there is no device
      dirty_ = true;
    }
    plannerWakes_.notify_all();
  }

  void moveHand(double dt, const OperatorFrame& frame, const std::optional<Pose>& put, bool restart,
                const Sight& sight) {
    if (restart) {
      tree_.reset();
      hand_.restart();
      movesAtRestart_ = hand_.sample().moves;
    }
    if (put) hand_.put(*put);
    if (sight.paused) return hand_.rest();
    if (sight.runEnded && hand_.isSimulated()) return;
    tree_.update(sight.chunks);
    const Se3Metric metric(sight.parameters.objectRadius());
    const auto target = guidanceTarget(sight.path.get(), sight.coarsePlan.get(), hand_.q_device(), metric);
    hand_.advance(dt, frame, tree_, guidanceOf(sight.parameters, target));
  }

  /// `run`: the run that the hand belongs to.
  void publishOperator(std::uint64_t run) {
    const OperatorSample& sample = hand_.sample();
    const std::lock_guard lock(mutex_);
    if (sample.moves != operatorSample_.moves || sample.guidance != operatorSample_.guidance ||
        sample.hand != operatorSample_.hand || sample.nearest.body != operatorSample_.nearest.body ||
        deviceConnected_ != hand_.connected() || held_ != hand_.held()) {
      dirty_ = true;
    }
    operatorSample_ = sample;
    deviceConnected_ = hand_.connected();
    held_ = hand_.held();
    const bool moved = sample.moves != movesAtRestart_;
    const bool begins = std::exchange(hasHandMoved_, moved) != moved;
    if (std::exchange(operatorRun_, run) != run || begins) plannerWakes_.notify_all();
  }

  /// Notifies the window. At most one notification is pending and at most one comes in a publishing interval.
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
    if (!guarded(GLISSADE_TEXT("announcing a snapshot"), wakeUp_)) return;
    const std::lock_guard lock(mutex_);
    wakeUpPending_ = false;  // the next tick tries again
  }

  SessionCore core_;                   ///< used by the planner thread
  OperatorHand hand_;                  ///< used by the operator thread
  StartTreeDistance tree_;             ///< used by the operator thread
  OperatorSample operatorSeen_;        ///< used by the planner thread: the operator's sample in this step
  std::uint64_t movesAtRestart_ = 0;   ///< used by the operator thread: OperatorSample::moves when the run began
  bool withHand_ = false;              ///< used by the planner thread: see command::Start
  Clock::time_point lastPublication_;  ///< used by the planner thread
  /// Used by the planner thread: time at which the last step was due, if steps have a pace.
  Clock::time_point lastStep_;

  mutable std::mutex mutex_;  ///< guards the members below up to the threads
  std::condition_variable plannerWakes_;
  std::condition_variable operatorWakes_;
  std::deque<Command> commands_;
  bool quit_ = false;
  StopSource stop_;
  SessionSnapshot planning_;
  OperatorFrame frame_;
  std::optional<Pose> putWanted_;
  std::uint64_t run_ = 0;          ///< number of the latest run
  std::uint64_t operatorRun_ = 0;  ///< number of the run at whose start, or after it, operatorSample_ was read
  RoadmapChunks chunks_;           ///< for the operator
  OperatorSample operatorSample_;
  bool held_ = false;
  bool hasHandMoved_ = false;  ///< since the run operatorRun_ has begun
  bool deviceConnected_ = true;
  std::optional<Diagnostic> operatorTrouble_;
  mutable bool dirty_ = true;
  mutable bool wakeUpPending_ = false;
  mutable std::uint64_t revision_ = 0;
  mutable SnapshotPtr snapshot_;
  Clock::time_point lastWakeUp_;

  std::mutex wakeUpMutex_;  ///< held while the window is notified: setWakeUp({}) returns after the last call
  std::function<void()> wakeUp_;

  std::thread operatorThread_;
  std::thread plannerThread_;
};

}  // namespace

std::unique_ptr<Session> makeThreadedSession(SessionConfig config) {
  return makeThreadedSession(std::move(config), makePlannerRegistry());
}

std::unique_ptr<Session> makeThreadedSession(SessionConfig config, PlannerRegistry planners) {
  auto device = std::move(config.device);
  return std::make_unique<Threaded>(std::move(config), std::move(device), std::move(planners));
}

}  // namespace glissade
