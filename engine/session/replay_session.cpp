#include "engine/session/replay_session.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/planning/coarse/scene_knowledge.h"
#include "engine/session/session_core.h"
#include "engine/session/session_with_planners.h"

namespace glissade {
namespace {

constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();

ParameterValues parametersOf(const RunLog& log, ReplayEnd end) {
  ParameterValues parameters = log.start.parameters;
  if (end == ReplayEnd::WithTheLog) (void)parameters.set(ParameterId::TimeLimit, 0.0);  // removes the limit
  return parameters;
}

Problem atStart(Problem problem, const RunStart& start) {
  problem.scene.edits = start.edits;
  return problem;
}

class Replay final : public ReplaySession {
 public:
  Replay(const Problem& problem, std::shared_ptr<const RunLog> log, ReplayEnd end, PlannerRegistry planners)
      : core_({atStart(problem, log->start), parametersOf(*log, end), log->start.planner, log->start.seed, nullptr},
              std::move(planners)),
        log_(std::move(log)),
        end_(end),
        query_(problem.world->makeQuery()),
        track_(std::make_shared<ReplayTrack>()) {
    hand_.q_device = problem.start;
    publish();
  }

  void post(Command command) override { commands_.push_back(std::move(command)); }
  void setOperatorFrame(const OperatorFrame& /*frame*/) override {}
  SnapshotPtr snapshot() const override { return snapshot_; }
  void setWakeUp(std::function<void()> wakeUp) override { wakeUp_ = std::move(wakeUp); }
  std::shared_ptr<const ReplayTrack> track() const override { return track_; }

  void advance(std::uint64_t steps, const StopToken& stop) override {
    for (const Command& command : std::exchange(commands_, {})) carryOut(command);
    std::uint64_t left = steps;
    while (left > 0 && core_.state() == SessionState::Planning && !stop.stopRequested()) {
      if (atEnd()) {
        core_.attempt(GLISSADE_TEXT("stopping the planner"), [this] { core_.carryOut(command::Stop{}); });
      } else {
        core_.attempt(GLISSADE_TEXT("planning"), [&] { plan(left, stop); });
      }
    }
    (void)core_.publish([this] { publish(); });  // a replay ends with its record
    if (wakeUp_) wakeUp_();
  }

 private:
  void carryOut(const Command& command) {
    const std::uint64_t runBefore = core_.run();
    core_.attempt(workOf(command), [&] { core_.carryOut(command); });
    if (core_.run() == runBefore) return;
    nextPose_ = nextParameter_ = nextEdits_ = 0;
    held_ = false;
    follow();
  }

  /// Goes on until the steps are done, an input changes, or the log ends.
  void plan(std::uint64_t& left, const StopToken& stop) {
    SessionCore::Hooks hooks;
    hooks.hand = [this] { return held_ ? std::make_optional(HandState{hand_.q_device, hand_.moves}) : std::nullopt; };
    hooks.operatorSample = [this] { return sample(); };
    hooks.seconds = [this] { return seconds(); };
    hooks.afterStep = [this, &left, &stop] {
      track_->add(core_.steps(), *core_.planner());
      moveHand();
      return --left > 0 && !stop.stopRequested() && nextChange() > core_.steps() && !atEnd();
    };
    hooks.stop = stop;
    core_.plan(hooks);
    follow();
  }

  /// Sets all external inputs to their state after the steps done so far.
  void follow() {
    const auto due = [this](const auto& entries, std::size_t next) {
      return next < entries.size() && entries[next].step <= core_.steps();
    };
    moveHand();
    for (; due(log_->parameterChanges, nextParameter_); ++nextParameter_) {
      const RunLog::ParameterChange& change = log_->parameterChanges[nextParameter_];
      const bool skipped = end_ == ReplayEnd::WithTheLog && change.id == ParameterId::TimeLimit;
      if (!skipped) core_.carryOut(command::SetParameter{change.id, change.value});
    }
    for (; due(log_->semanticChanges, nextEdits_); ++nextEdits_) {
      core_.carryOut(command::SetSemantics{log_->semanticChanges[nextEdits_].edits});
    }
  }

  std::uint64_t nextChange() const {
    const auto step = [](const auto& entries, std::size_t next) {
      return next < entries.size() ? entries[next].step : kNever;
    };
    return std::min(step(log_->parameterChanges, nextParameter_), step(log_->semanticChanges, nextEdits_));
  }

  void moveHand() {
    const auto& stream = log_->operatorStream;
    for (; nextPose_ < stream.size() && stream[nextPose_].step <= core_.steps(); ++nextPose_) {
      held_ = stream[nextPose_].q_device.has_value();
      if (!held_) continue;
      hand_.q_device = *stream[nextPose_].q_device;
      hand_.moves = nextPose_;
      nearestIsKnown_ = false;
    }
  }

  const OperatorSample& sample() {
    if (!nearestIsKnown_) hand_.nearest = query_->nearestObstacle(hand_.q_device);
    nearestIsKnown_ = true;
    return hand_;
  }

  bool atEnd() const {
    if (end_ == ReplayEnd::Continue) return false;
    if (!log_->end) return true;
    // Records of version 1 have no step.
    return log_->end->step > 0 ? core_.steps() >= log_->end->step : core_.planner()->nodes().size() >= log_->end->nodes;
  }

  void publish() {
    auto next = std::make_shared<SessionSnapshot>();
    core_.describe(*next);
    next->revision = ++revision_;
    next->virtualSeconds = seconds();
    next->device = sample();
    snapshot_ = std::move(next);
  }

  double seconds() const {
    return static_cast<double>(core_.steps()) * (1.0 / core_.parameters()[ParameterId::StepsPerSecond]);
  }

  SessionCore core_;
  std::shared_ptr<const RunLog> log_;
  ReplayEnd end_;
  std::unique_ptr<CollisionQuery> query_;
  std::shared_ptr<ReplayTrack> track_;
  OperatorSample hand_;
  bool held_ = false;
  bool nearestIsKnown_ = false;
  std::size_t nextPose_ = 0;
  std::size_t nextParameter_ = 0;
  std::size_t nextEdits_ = 0;
  std::vector<Command> commands_;
  std::function<void()> wakeUp_;
  std::uint64_t revision_ = 0;
  SnapshotPtr snapshot_;
};

}  // namespace

std::unique_ptr<ReplaySession> makeReplaySession(const Problem& problem, std::shared_ptr<const RunLog> log,
                                                 ReplayEnd end) {
  return makeReplaySession(problem, std::move(log), end, makePlannerRegistry());
}

std::unique_ptr<ReplaySession> makeReplaySession(const Problem& problem, std::shared_ptr<const RunLog> log,
                                                 ReplayEnd end, PlannerRegistry planners) {
  return std::make_unique<Replay>(problem, std::move(log), end, std::move(planners));
}

Result<Problem> withRecordedKnowledge(Problem problem, const RunLog& log, const StopToken& stop) {
  problem.scene.knowledge = nullptr;
  if (!log.start.knowledge) return problem;
  const KnowledgeSource& source = *log.start.knowledge;
  Problem asked = problem;
  asked.scene.environment = source.options;
  asked.scene.edits = source.edits;
  auto knowledge = buildSceneKnowledge(asked, source.requiredClearance, stop);
  if (!knowledge) return knowledge.error();
  problem.scene.knowledge = std::move(*knowledge);
  return problem;
}

void overrideParameter(ParameterId id, double value, RunLog& log) {
  (void)log.start.parameters.set(id, value);
  auto& changes = log.parameterChanges;
  changes.erase(std::remove_if(changes.begin(), changes.end(), [id](const auto& change) { return change.id == id; }),
                changes.end());
}

}  // namespace glissade
