#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/parameters.h"
#include "engine/environment/knowledge_source.h"
#include "engine/geometry/pose.h"

namespace glissade {

/// What a run started from.
struct RunStart {
  std::string planner;
  std::uint64_t seed = 1;
  ParameterValues parameters{1.0};
  std::shared_ptr<const SemanticEdits> edits;  ///< null: none
  std::optional<KnowledgeSource> knowledge;    ///< of the environment model; nothing: the planner built it, if at all
};

/// How far the roadmap was after a step, so that a replay can be compared with the run.
struct RunCheckpoint {
  std::uint64_t step = 0;
  std::uint64_t nodes = 0;
  std::uint64_t edges = 0;  ///< undirected, dropped ones with them
  std::uint64_t hash = 0;   ///< of all nodes and edges (session/roadmap_hash.h)
  double seconds = 0.0;     ///< of planning up to here, in the run's own time; not compared
};

/// Everything from outside that shaped a run: with the scenario enough to grow the same roadmap
/// again, bit by bit. Its clock counts session steps, that is how often the planner came back to the
/// session: once an Add_Tree, and once a pass where a multi-layer planner decides something. An entry
/// of step n was in force from the pass on that followed n others. Pauses leave no trace.
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
    std::optional<Pose> q_device;  ///< nothing: nobody held the object from then on
  };

  RunStart start;
  std::vector<ParameterChange> parameterChanges;
  std::vector<SemanticChange> semanticChanges;
  std::vector<HandPose> operatorStream;    ///< an entry each time the object was moved, ascending steps
  std::vector<RunCheckpoint> checkpoints;  ///< every kCheckpointInterval steps
  /// The last step that was not cut off by a stop. Of records of version 1 it holds the nodes alone.
  std::optional<RunCheckpoint> end;
  bool cutShort = false;  ///< the run went on, but the log was full
};

/// The run's own time after so many steps, and back: straight between checkpoints. Where a log holds
/// no times, a step is 1 / steps_per_second.
double secondsAt(const RunLog& log, std::uint64_t step);
std::uint64_t stepAt(const RunLog& log, double seconds);

/// Steps between two checkpoints.
inline constexpr std::uint64_t kCheckpointInterval = 1000;
/// A log ends after so many operator poses (hours of unbroken motion, some 100 MB).
inline constexpr std::uint64_t kMostHandPoses = 1'000'000;

/// A log as a session publishes it while it grows: each part continues the one before it.
using RunLogParts = std::vector<std::shared_ptr<const RunLog>>;

/// Appends a part to a log that it continues.
void append(const RunLog& part, RunLog& log);
/// Precondition: at least one part.
RunLog joined(const RunLogParts& parts);

}  // namespace glissade
