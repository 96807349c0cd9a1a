#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/parameters.h"
#include "engine/geometry/pose.h"
#include "engine/places/knowledge_source.h"

namespace glissade {

/// Initial state of a run.
struct RunStart {
  std::string planner;
  std::uint64_t seed = 1;
  ParameterValues parameters{1.0};
  std::shared_ptr<const SemanticEdits> edits;  ///< null: none
  /// Source of the environment model; nothing: the planner built it, or none was used.
  std::optional<KnowledgeSource> knowledge;
};

/// Roadmap after a step, for comparing a replay with the run.
struct RunCheckpoint {
  std::uint64_t step = 0;
  std::uint64_t nodes = 0;
  std::uint64_t edges = 0;  ///< undirected edges, including dropped ones
  std::uint64_t hash = 0;   ///< hash of all nodes and edges (session/roadmap_hash.h)
  double seconds = 0.0;     ///< planning time up to this step, in the run's own time; not compared
};

/// All external inputs of a run: with the scenario they suffice to grow the same roadmap again, bit by bit. The clock
/// counts session steps, the calls of the planner to the session: one for each Add_Tree, and one for each pass in which
/// a multi-layer planner decides. An entry of step n was in force from the pass that followed n others. Pauses are not
/// recorded.
struct RunLog {
  struct ParameterChange {
    std::uint64_t step = 0;
    ParameterId id = ParameterId::Alpha;
    double value = 0.0;
  };
  struct SemanticChange {
    std::uint64_t step = 0;
    std::shared_ptr<const SemanticEdits> edits;
  };
  struct HandPose {
    std::uint64_t step = 0;
    std::optional<Pose> q_device;  ///< nothing: nobody held the object from this step on
  };

  RunStart start;
  std::vector<ParameterChange> parameterChanges;
  std::vector<SemanticChange> semanticChanges;
  std::vector<HandPose> operatorStream;    ///< one entry for each change of the pose, by ascending steps
  std::vector<RunCheckpoint> checkpoints;  ///< one checkpoint every kCheckpointInterval steps
  /// The last step that a stop did not interrupt. In records of version 1 it has the nodes only.
  std::optional<RunCheckpoint> end;
  bool cutShort = false;  ///< the run went on after the log was full
};

/// Converts steps to the run's own time and back, by linear interpolation between checkpoints. Where a log has no
/// times, a step is 1 / steps_per_second.
double secondsAt(const RunLog& log, std::uint64_t step);
std::uint64_t stepAt(const RunLog& log, double seconds);

/// Steps between two checkpoints.
inline constexpr std::uint64_t kCheckpointInterval = 1000;
/// Most operator poses of a log (hours of unbroken motion, some 100 MB).
inline constexpr std::uint64_t kMostHandPoses = 1'000'000;

/// A log as a session publishes it while it grows; each part continues the one before it.
using RunLogParts = std::vector<std::shared_ptr<const RunLog>>;

/// Appends a part that continues the log.
void append(const RunLog& part, RunLog& log);
/// Joins the parts. Precondition: there is at least one.
RunLog joined(const RunLogParts& parts);

}  // namespace glissade
