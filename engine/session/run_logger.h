#pragma once

#include <chrono>

#include "engine/operator/run_log.h"
#include "engine/session/operator_hand.h"
#include "engine/session/roadmap_hash.h"

namespace glissade {

/// Keeps the log of one run after the other, and publishes it in parts. Lives where the planner does.
class RunLogger {
 public:
  void start(RunStart start);
  /// What is noted takes effect after the steps done so far.
  void note(ParameterId id, double value);
  void note(const std::shared_ptr<const SemanticEdits>& edits);
  void noteHand(const std::optional<HandState>& hand);
  /// The planner came back, so many seconds after the start; `whole`: nothing cut its step off.
  void stepDone(const Planner& planner, double seconds, bool whole);

  std::uint64_t steps() const { return steps_; }
  /// The object is in somebody's hand, moved so often since the start.
  bool held() const { return held_; }
  std::uint64_t handMoves() const { return handPoses_ - 1; }

  /// All parts; what is new becomes one where the last is a second old, or the run has ended.
  const RunLogParts& parts(bool ended);

 private:
  RunLog pending_;
  RunLogParts parts_;
  bool news_ = false;
  std::chrono::steady_clock::time_point lastPart_;
  RoadmapHash hash_;
  std::uint64_t steps_ = 0;
  std::uint64_t handPoses_ = 0;
  std::uint64_t lastMoves_ = 0;  ///< HandState::moves of the pose noted last
  bool held_ = false;
};

}  // namespace glissade
