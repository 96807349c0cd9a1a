#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "engine/operator/operator_input.h"
#include "engine/operator/run_log.h"
#include "engine/planning/coarse/coarse_plan.h"
#include "engine/planning/contact/interaction_settings.h"
#include "engine/planning/interactive/hand_report.h"
#include "engine/planning/path_examination.h"
#include "engine/planning/planner.h"

namespace glissade {

enum class SessionState {
  Idle,  ///< ready; the operator may move, nothing is planned
  Planning,
  Paused,
  Solved,   ///< `path` is there
  Stopped,  ///< by the user; what was found so far stays shown
  Failed    ///< see `problem`: start or goal in collision, limit reached, internal error
};

/// What the window asks of the engine. Carried out in order.
namespace command {
struct Start {};  ///< from Idle, Stopped, Solved, Failed: a fresh roadmap with the current seed
struct Pause {};
struct Resume {};
struct Stop {};
struct SetSeed {
  std::uint64_t seed;
};  ///< takes effect at the next Start
struct SetPlanner {
  std::string id;
};  ///< takes effect at the next Start
struct SetParameter {
  ParameterId id;
  double value;
};  ///< takes effect at the next iteration
struct SetSemantics {
  SemanticEditsPtr edits;
};  ///< takes effect at the next iteration: the coarse plan follows
struct SetKnowledge {
  std::shared_ptr<const SceneKnowledge> knowledge;
};  ///< the environment model, once built; takes effect at the next Start
struct SetDevicePose {
  Pose q_device;
};  ///< puts the object in the operator's hand there
struct SmoothPath {
  int attempts;
};  ///< once Solved: the path as planned with that many shortcuts tried; 0: as planned again
struct ExaminePath {
  std::vector<PathPoint> points;  ///< at least one
  PathProvenance provenance;
};  ///< before the first Start: a path from elsewhere. Solved where it holds here, else `refused` is there
}  // namespace command
using Command = std::variant<command::Start, command::Pause, command::Resume, command::Stop, command::SetSeed,
                             command::SetPlanner, command::SetParameter, command::SetSemantics, command::SetKnowledge,
                             command::SetDevicePose, command::SmoothPath, command::ExaminePath>;

/// What is done with a path, which takes its time; Stop ends it.
struct PathWork {
  enum class Kind { Smoothing, Examination };
  Kind kind = Kind::Smoothing;
  double share = 0.0;  ///< done
};

/// Everything the window shows, frozen at one moment; shared and never changed.
struct SessionSnapshot {
  std::uint64_t revision = 0;  ///< grows with every publication
  std::uint64_t run = 0;       ///< grows with every Start: a new run has a new roadmap
  SessionState state = SessionState::Idle;
  std::optional<Diagnostic> problem;  ///< why Failed, or why the last command was refused
  std::string plannerId;
  std::uint64_t seed = 0;
  ParameterValues parameters{1.0};
  PlannerCounts counts;
  double virtualSeconds = 0.0;      ///< the operator's clock: real time in the window, lockstep time headless
  double planningSeconds = 0.0;     ///< time spent planning, pauses excluded
  double planningCpuSeconds = 0.0;  ///< of all threads that plan; known between the planner's turns only
  Author authority = Author::Computer;
  bool contactMode = false;
  OperatorSample device;  ///< q_device and its nearest obstacle
  bool deviceConnected = true;
  RoadmapChunks roadmap;
  PerAuthor<std::uint64_t> nodesByAuthor{};
  std::vector<RoadmapEdge> droppedEdges;
  CoarsePlanPtr coarsePlan;                        ///< of a multi-layer planner; null otherwise
  std::shared_ptr<const Path> path;                ///< certified; null until solved
  bool smoothed = false;                           ///< `path` was shortened after it was planned
  std::shared_ptr<const PathExamination> refused;  ///< a path that was given and does not hold here; null: none
  PathProvenance provenance;                       ///< of `path` or of the refused one
  std::optional<PathWork> pathWork;                ///< under way
  RunLogParts log;                     ///< what shaped the run: at most a second old, and whole once it has ended
  std::string member;                  ///< of the automatic planner: whose turn it is, or who found the path
  std::optional<TuningReport> tuning;  ///< what has set itself; `parameters` stay the user's own
  std::optional<HandReport> hand;      ///< what came of what the hand has shown; nothing: no strategy asks for it
};
using SnapshotPtr = std::shared_ptr<const SessionSnapshot>;

/// A run is under way, held or not.
inline bool isRunning(const SessionSnapshot& snapshot) {
  return snapshot.state == SessionState::Planning || snapshot.state == SessionState::Paused;
}

/// A parameter's value in force: the tuner's where it sets itself, else the user's.
inline double valueInForce(const SessionSnapshot& snapshot, ParameterId id) {
  const bool tuned = snapshot.tuning && (snapshot.parameters.integer(ParameterId::Tuning) & tunedSetting(id)) != 0;
  return tuned ? snapshot.tuning->now[id] : snapshot.parameters[id];
}

/// What a session works on. The world is shared; the device is owned by the session.
struct SessionConfig {
  Problem problem;
  ParameterValues parameters;
  std::string plannerId = "contact-birrt";
  std::uint64_t seed = 1;
  std::unique_ptr<OperatorDevice> device;  ///< null: no operator
};

/// Commands in, snapshots out. Two implementations under the same tests: ThreadedSession (operator
/// thread and planner thread, real time) and LockstepSession (no thread, virtual time).
/// All functions may be called from any one thread (the GUI's) and never block on planning.
class Session {
 public:
  virtual ~Session() = default;

  virtual void post(Command command) = 0;
  /// The view and speeds that deflections are read with; latest wins.
  virtual void setOperatorFrame(const OperatorFrame& frame) = 0;
  /// Never null.
  virtual SnapshotPtr snapshot() const = 0;
  /// Called (from any thread) when a new snapshot is there; at most one call is pending: the next
  /// comes only after snapshot() was read again, and at most 60 a second.
  virtual void setWakeUp(std::function<void()> wakeUp) = 0;
};

/// A session with its own operator thread and planner thread, in real time.
std::unique_ptr<Session> makeThreadedSession(SessionConfig config);

/// The thread-less twin: nothing happens but inside `advance`, and every planner step takes
/// 1 / steps_per_second of the operator's time. Same scenario, seed and inputs: same roadmap, bit by bit.
class LockstepSession : public Session {
 public:
  /// Carries out posted commands, then runs at most this many planner steps (fewer when the run
  /// ends, or when asked to stop, also inside a long check). While not planning, lets the operator
  /// move for the same time.
  virtual void advance(std::uint64_t steps, const StopToken& stop = {}) = 0;
};
std::unique_ptr<LockstepSession> makeLockstepSession(SessionConfig config);

}  // namespace glissade
