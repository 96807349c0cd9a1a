#pragma once

#include "engine/session/replay_track.h"
#include "engine/session/session.h"

namespace glissade {

/// Whether a replay ends where the log ends, or goes on with the object at rest: what would have
/// become of the run with other parameters.
enum class ReplayEnd { WithTheLog, GoOn };

/// A run whose operator, parameters and semantic edits come from a log instead of from people. Its
/// clock is that of lockstep. WithTheLog, the recorded time limit is left out: time is not repeatable.
class ReplaySession : public LockstepSession {
 public:
  /// Filled while it runs; may be read from any thread as long as the session lives.
  virtual std::shared_ptr<const ReplayTrack> track() const = 0;
};

/// The problem as it was recorded, with the environment model built from log.start.knowledge where
/// there is one (withRecordedKnowledge).
std::unique_ptr<ReplaySession> makeReplaySession(const Problem& problem, std::shared_ptr<const RunLog> log,
                                                 ReplayEnd end = ReplayEnd::WithTheLog);

/// The problem with the environment model that the run had. Errors are those of buildSceneKnowledge.
Result<Problem> withRecordedKnowledge(Problem problem, const RunLog& log, const StopToken& stop = {});

/// The log with another value of a parameter from the start to the end. Precondition: in range.
void overrideParameter(ParameterId id, double value, RunLog& log);

}  // namespace glissade
