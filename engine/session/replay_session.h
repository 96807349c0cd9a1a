#pragma once

#include "engine/session/replay_track.h"
#include "engine/session/session.h"

namespace glissade {

/// End of a replay: with the log, or later with the object at rest, which shows the run with other parameters.
enum class ReplayEnd { WithTheLog, Continue };

/// A run whose operator, parameters and semantic edits come from a log instead of from people. Its clock is that of
/// lockstep. With ReplayEnd::WithTheLog the recorded time limit is ignored, because time is not repeatable.
class ReplaySession : public LockstepSession {
 public:
  /// The track, which is filled while the session runs. It may be read from any thread as long as the session lives.
  virtual std::shared_ptr<const ReplayTrack> track() const = 0;
};

/// Makes a replay of the recorded problem, with the environment model built from log.start.knowledge, if there is one
/// (withRecordedKnowledge).
std::unique_ptr<ReplaySession> makeReplaySession(const Problem& problem, std::shared_ptr<const RunLog> log,
                                                 ReplayEnd end = ReplayEnd::WithTheLog);

/// The problem with the environment model of the run. Errors are those of buildSceneKnowledge.
Result<Problem> withRecordedKnowledge(Problem problem, const RunLog& log, const StopToken& stop = {});

/// Sets a parameter of the log from the start to the end. Precondition: the value is in range.
void overrideParameter(ParameterId id, double value, RunLog& log);

}  // namespace glissade
