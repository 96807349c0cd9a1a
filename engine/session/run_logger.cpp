#include "engine/session/run_logger.h"

#include <utility>

namespace glissade {
namespace {

constexpr std::chrono::seconds kPartInterval{1};

}  // namespace

void RunLogger::start(RunStart start) {
  *this = RunLogger();
  pending_.start = std::move(start);
  news_ = true;
}

void RunLogger::note(ParameterId id, double value) {
  if (pending_.cutShort) return;
  pending_.parameterChanges.push_back({steps_, id, value});
  news_ = true;
}

void RunLogger::note(const std::shared_ptr<const SemanticEdits>& edits) {
  if (pending_.cutShort) return;
  pending_.semanticChanges.push_back({steps_, edits});
  news_ = true;
}

void RunLogger::noteHand(const std::optional<HandState>& hand) {
  const bool same = hand ? held_ && lastMoves_ == hand->moves : !held_;
  if (same) return;
  held_ = hand.has_value();
  if (hand) lastMoves_ = hand->moves;
  if (++handPoses_ > kMostHandPoses) pending_.cutShort = true;
  if (pending_.cutShort) return;
  pending_.operatorStream.push_back({steps_, hand ? std::make_optional(hand->q_device) : std::nullopt});
  news_ = true;
}

void RunLogger::stepDone(const Planner& planner, double seconds, bool whole) {
  ++steps_;
  hash_.update(planner);
  if (!whole || pending_.cutShort) return;
  const RunCheckpoint now{steps_, planner.nodes().size(), planner.edges().size(), hash_.value(), seconds};
  if (steps_ % kCheckpointInterval == 0) pending_.checkpoints.push_back(now);
  pending_.end = now;
  news_ = true;
}

const RunLogParts& RunLogger::parts(bool ended) {
  const auto now = std::chrono::steady_clock::now();
  if (!news_ || (!ended && !parts_.empty() && now - lastPart_ < kPartInterval)) return parts_;
  RunLog next;
  next.start = pending_.start;
  next.cutShort = pending_.cutShort;
  const auto part = std::make_shared<RunLog>();
  parts_.push_back(part);
  *part = std::exchange(pending_, std::move(next));  // does not throw, so that no entry is lost when memory ends
  lastPart_ = now;
  news_ = false;
  return parts_;
}

}  // namespace glissade
