#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "engine/base/guarded.h"
#include "engine/base/work_watch.h"
#include "engine/planning/coarse/prohibitions.h"
#include "engine/planning/planner.h"
#include "engine/session/run_logger.h"
#include "engine/session/session.h"

namespace glissade {

/// Turns a planner's growing roadmap into immutable chunks: what was published is shared, never
/// copied again.
class RoadmapPublisher {
 public:
  /// Publishes what came since the last call.
  void update(const Planner& planner);
  void reset();

  const RoadmapChunks& chunks() const { return chunks_; }
  const std::vector<RoadmapEdge>& droppedEdges() const { return dropped_; }
  const PerAuthor<std::uint64_t>& nodesByAuthor() const { return nodesByAuthor_; }

 private:
  RoadmapChunks chunks_;
  std::vector<RoadmapEdge> dropped_;
  PerAuthor<std::uint64_t> nodesByAuthor_{};
  std::size_t nodes_ = 0;
  std::size_t edges_ = 0;
};

/// Name of the work for a command, for guarded().
CatalogueText workOf(const Command& command);

/// The common part of a session's two implementations: the state machine of a run. It is used on the planning thread
/// (or in the lockstep loop) and has no threads nor operator clocks.
class SessionCore {
 public:
  /// Takes all inputs except the device.
  SessionCore(SessionConfig config, PlannerRegistry planners);
  ~SessionCore();

  /// Carries out every command except SetDevicePose, which belongs to the operator's side. `watch` is for SmoothPath
  /// and ExaminePath, which may take long; after a stop all stays as it was.
  void carryOut(const Command& command, const WorkWatch& watch = {});

  /// Calls `work`, which calls carryOut() or plan(). Only here an exception becomes the session's problem: a run under
  /// way ends as Failed, or as Solved where its path was delivered. The next Start begins anew.
  template <class Work>
  void attempt(CatalogueText doing, const Work& work) {
    if (auto why = guarded(doing, work)) endAfterException(std::move(*why));
  }
  /// Calls `publish`, which calls describe(), between two turns of the planner. Where that fails the run ends, its
  /// planner is put into plannerAside_ and `publish` is called once more. False: that failed, too, so the window knows
  /// nothing of it.
  template <class Publish>
  [[nodiscard]] bool publish(const Publish& publish) {
    constexpr CatalogueText kDoing = GLISSADE_TEXT("publishing the roadmap");
    auto why = guarded(kDoing, publish);
    if (!why) return true;
    endAfterException(std::move(*why));
    setPlannerAside();
    return !guarded(kDoing, publish);
  }

  SessionState state() const { return state_; }
  /// Number of runs started so far.
  std::uint64_t run() const { return run_; }
  /// Session steps of this run: number of returns of the planner (RunLog's clock).
  std::uint64_t steps() const { return logger_.steps(); }

  /// Functions of the session that plan() needs.
  struct Hooks {
    /// State of the object in the operator's hand, requested once before each step. Nothing: nobody holds it.
    std::function<std::optional<HandState>()> hand;
    /// The held object with its nearest obstacle, requested when the planner needs it.
    std::function<OperatorSample()> operatorSample;
    std::function<double()> seconds;  ///< seconds since the start, in the run's own time
    std::function<bool()> afterStep;  ///< false: plan() returns and may be called again later
    StopToken stop;
  };
  /// Grows the roadmap until the run ends or a hook ends the call. Precondition: state() == Planning. Passes on the
  /// planner's exceptions.
  void plan(const Hooks& hooks);

  /// Fills in the planning side of a snapshot and publishes new roadmap nodes.
  void describe(SessionSnapshot& snapshot);

  /// Time spent planning, without pauses.
  double planningSeconds() const;
  /// Processor time of planning: of the thread that calls this, which plans, and of the planner's helpers.
  double planningCpuSeconds() const;
  const Problem& problem() const { return problem_; }
  const ParameterValues& parameters() const { return parameters_; }
  const Planner* planner() const { return planner_.get(); }
  /// The path; null until solved.
  const Path* path() const { return path_.get(); }

 private:
  class Host;

  void startRun(const StopToken& stop);
  void setNames(const CollisionWorldPtr& world);
  void forgetFailure();
  void setSemantics(const SemanticEditsPtr& edits, const WorkWatch& watch);
  Outcome forbidByEdits(const StopToken& stop);
  std::optional<std::string> forbiddenOn(const Path& path) const;
  void certifyAgain(const WorkWatch& watch);
  void judge(const command::ExaminePath& given, const WorkWatch& watch);
  void setPlanner(const std::string& id);
  void setParameter(ParameterId id, double value);
  void smoothPath(int attempts, const WorkWatch& watch);
  void examine(const command::ExaminePath& given, const WorkWatch& watch);
  void deliverPath(const StopToken& stop);
  void endRun(SessionState state);
  void fail(Diagnostic why);
  void endAfterException(Diagnostic why);
  void setPlannerAside();
  void stopClock();
  std::optional<Diagnostic> limitReached() const;
  StopToken withTimeLimit(const StopToken& stop) const;

  std::shared_ptr<ForbiddenSpace> forbidden_ = std::make_shared<ForbiddenSpace>();
  Prohibitions prohibitions_;
  Problem problem_;  ///< problem whose world keeps out of forbidden_
  PlannerRegistry registry_;
  ParameterValues parameters_;
  std::string plannerId_;
  std::uint64_t seed_;

  SessionState state_ = SessionState::Idle;
  std::optional<Diagnostic> trouble_;
  std::uint64_t run_ = 0;
  std::unique_ptr<Planner> planner_;
  /// A planner that is not used any more. It lives until the next Start, because OMPL's destructors allocate memory and
  /// end the program where there is none.
  std::unique_ptr<Planner> plannerAside_;
  RoadmapPublisher roadmap_;
  std::shared_ptr<const Path> path_;     ///< delivered path
  std::shared_ptr<const Path> planned_;  ///< delivered path before it was smoothed
  bool smoothed_ = false;                ///< path_ differs from planned_
  std::shared_ptr<const PathExamination> refused_;
  PathProvenance provenance_;  ///< provenance of path_ or refused_
  RunLogger logger_;
  std::chrono::duration<double> spent_{0};
  double cpuSpent_ = 0.0;   ///< processor time, seconds
  double cpuBefore_ = 0.0;  ///< processor time at planningSince_, seconds
  std::optional<std::chrono::steady_clock::time_point> planningSince_;
};

}  // namespace glissade
