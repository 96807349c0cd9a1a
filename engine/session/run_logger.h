#pragma once

#include <chrono>

#include "engine/operator/run_log.h"
#include "engine/session/operator_hand.h"
#include "engine/session/roadmap_hash.h"

namespace glissade {

/// Keeps the logs of successive runs, and publishes them in parts. Used by the planner's thread.
class RunLogger {
 public:
  void start(RunStart start);
  /// Notes a change that takes effect after the steps done so far.
  void note(ParameterId id, double value);
  void note(const std::shared_ptr<const SemanticEdits>& edits);
  void noteHand(const std::optional<HandState>& hand);
  /// The planner returned, `seconds` after the start; `whole`: its step was not interrupted.
  void stepDone(const Planner& planner, double seconds, bool whole);

  std::uint64_t steps() const { return steps_; }
  /// True if a person holds the object; handMoves() is the number of its moves since the start.
  bool held() const { return held_; }
  std::uint64_t handMoves() const { return handPoses_ - 1; }

  /// All parts. New entries become a part if the last part is a second old, or the run has ended.
  const RunLogParts& parts(bool ended);

 private:
  RunLog pending_;
  RunLogParts parts_;
  bool news_ = false;
  std::chrono::steady_clock::time_point lastPart_;
  RoadmapHash hash_;
  std::uint64_t steps_ = 0;
  std::uint64_t handPoses_ = 0;
  std::uint64_t lastMoves_ = 0;  ///< HandState::moves of the last noted pose
  bool held_ = false;
};

}  // namespace glissade
