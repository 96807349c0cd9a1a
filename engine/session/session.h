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
  Idle,  ///< ready; the operator may move, and no planner runs
  Planning,
  Paused,
  Solved,   ///< `path` exists
  Stopped,  ///< stopped by the user; the results so far stay displayed
  Failed    ///< see `problem`: start or goal in collision, limit reached, internal error
};

/// Requests of the window to the engine, carried out in order.
namespace command {
struct Start {
  /// In real time, planning begins with the first motion of the hand, unless nobody holds the object or the computer's
  /// share is all.
  bool withHand = false;
};                ///< from Idle, Stopped, Solved, Failed: a fresh roadmap with the current seed
struct Pause {};  ///< neither the planner nor the object in the operator's hand goes on until Resume
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
struct SetNames {
  CollisionWorldPtr world;
};  ///< the same world with other names of bodies, for messages from now on
struct SetDevicePose {
  Pose q_device;
};  ///< puts the object at this pose in the operator's hand
struct SmoothPath {
  int attempts;
};  ///< once Solved: delivers the path as planned with that many attempts of shortcuts; 0: as planned
struct ExaminePath {
  std::vector<PathPoint> points;  ///< at least one point
  PathProvenance provenance;
};  ///< before the first Start: examines a path from elsewhere. Solved if it holds here, else `refused` is set
}  // namespace command
using Command = std::variant<command::Start, command::Pause, command::Resume, command::Stop, command::SetSeed,
                             command::SetPlanner, command::SetParameter, command::SetSemantics, command::SetKnowledge,
                             command::SetNames, command::SetDevicePose, command::SmoothPath, command::ExaminePath>;

/// Work on a path, which may take long; Stop ends it.
struct PathWork {
  enum class Kind { Smoothing, Examination };
  Kind kind = Kind::Smoothing;
  double share = 0.0;  ///< share that is done
};

/// All data that the window displays, at one moment; shared and never changed.
struct SessionSnapshot {
  std::uint64_t revision = 0;  ///< number that grows with every publication
  std::uint64_t run = 0;       ///< number that grows with every Start, which begins a new roadmap
  SessionState state = SessionState::Idle;
  std::optional<Diagnostic> problem;  ///< reason for Failed, or for the refusal of the last command
  std::string plannerId;
  std::uint64_t seed = 0;
  ParameterValues parameters{1.0};
  PlannerCounts counts;
  double virtualSeconds = 0.0;      ///< the operator's clock: real time in the window, lockstep time without one
  double planningSeconds = 0.0;     ///< time spent planning, without pauses
  double planningCpuSeconds = 0.0;  ///< processor time of all threads that plan
  Author authority = Author::Computer;
  bool contactMode = false;
  bool waitsForHand = false;  ///< planning begins with the first motion of the hand
  OperatorSample device;      ///< q_device and its nearest obstacle
  bool deviceConnected = true;
  RoadmapChunks roadmap;
  PerAuthor<std::uint64_t> nodesByAuthor{};
  std::vector<RoadmapEdge> droppedEdges;
  CoarsePlanPtr coarsePlan;                        ///< coarse plan of a multi-layer planner; null otherwise
  std::shared_ptr<const Path> path;                ///< certified path; null until solved
  bool smoothed = false;                           ///< `path` was shortened after it was planned
  std::shared_ptr<const PathExamination> refused;  ///< a given path that does not hold here; null: none
  PathProvenance provenance;                       ///< provenance of `path` or of the refused path
  std::optional<PathWork> pathWork;                ///< work under way
  RunLogParts log;     ///< log of the run: at most a second old, and complete once the run has ended
  std::string member;  ///< for the automatic planner: members that have the turn, or the member that found the path
  std::optional<TuningReport> tuning;  ///< automatic settings; `parameters` stay the user's own
  std::optional<HandReport> hand;      ///< effect of the hand's configurations; nothing: the strategy does not use them
};
using SnapshotPtr = std::shared_ptr<const SessionSnapshot>;

/// True if a run is under way, paused or not.
inline bool isRunning(const SessionSnapshot& snapshot) {
  return snapshot.state == SessionState::Planning || snapshot.state == SessionState::Paused;
}

/// The value of a parameter in force: the tuner's where it is automatic, else the user's.
inline double valueInForce(const SessionSnapshot& snapshot, ParameterId id) {
  const bool tuned = snapshot.tuning && (snapshot.parameters.integer(ParameterId::Tuning) & tunedSetting(id)) != 0;
  return tuned ? snapshot.tuning->now[id] : snapshot.parameters[id];
}

/// Inputs of a session. The world is shared; the session owns the device.
struct SessionConfig {
  Problem problem;
  ParameterValues parameters;
  std::string plannerId = "contact-birrt";
  std::uint64_t seed = 1;
  std::unique_ptr<OperatorDevice> device;  ///< null: no operator
};

/// Takes commands and publishes snapshots. Two implementations under the same tests: ThreadedSession (operator thread
/// and planner thread, real time) and LockstepSession (no thread, virtual time). All functions may be called from any
/// one thread (the GUI's) and never wait for planning.
class Session {
 public:
  virtual ~Session() = default;

  virtual void post(Command command) = 0;
  /// Sets the view and speeds for deflections. The latest one counts.
  virtual void setOperatorFrame(const OperatorFrame& frame) = 0;
  /// The latest snapshot; never null.
  virtual SnapshotPtr snapshot() const = 0;
  /// Sets a function that is called (from any thread) when there is a new snapshot. At most one call is pending: the
  /// next comes only after snapshot() was read again, and at most 60 times a second.
  virtual void setWakeUp(std::function<void()> wakeUp) = 0;
};

/// A session with its own operator thread and planner thread, in real time.
std::unique_ptr<Session> makeThreadedSession(SessionConfig config);

/// A session without threads: it works only inside `advance`, and every planner step takes 1 / steps_per_second of the
/// operator's time. The same scenario, seed and inputs give the same roadmap, bit by bit.
class LockstepSession : public Session {
 public:
  /// Carries out posted commands, then runs at most this many planner steps (fewer when the run ends, or after a stop,
  /// also inside a long check). While not planning, the operator moves for the same time.
  virtual void advance(std::uint64_t steps, const StopToken& stop = {}) = 0;
};
std::unique_ptr<LockstepSession> makeLockstepSession(SessionConfig config);

}  // namespace glissade
