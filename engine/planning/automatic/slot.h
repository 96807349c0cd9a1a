#pragma once

#include "engine/planning/fine/sub_planner.h"

namespace glissade {

/// What one member did in a round.
struct SlotResult {
  SubPlanner::State state = SubPlanner::State::Running;
  std::uint64_t work = 0;   ///< queries and steps, by what they cost; never seconds
  std::uint64_t turns = 0;  ///< of one step
  bool gotOn = false;       ///< it has done another of its stages
};

/// Lets one life of a member have turns until it has spent the quantum, has ended, or is stopped;
/// at least one. Its growth is not collected. On any thread: of the host it needs what may be asked by
/// several at once.
SlotResult runSlot(SubPlanner& life, PlannerHost& host, std::uint64_t quantum);

/// The host of a round, for all of its slots at once: what could change meanwhile is as it was when the
/// round began. Made on the planner's thread.
class RoundHost final : public PlannerHost {
 public:
  explicit RoundHost(PlannerHost& host) : host_(host), operator_(host.operatorSample()), edits_(host.semanticEdits()) {}

  std::optional<OperatorSample> operatorSample() override { return operator_; }
  const ParameterValues& parameters() const override { return host_.parameters(); }
  bool afterStep() override { return false; }
  const StopToken& stopToken() const override { return host_.stopToken(); }
  SemanticEditsPtr semanticEdits() const override { return edits_; }

 private:
  PlannerHost& host_;
  std::optional<OperatorSample> operator_;
  SemanticEditsPtr edits_;
};

}  // namespace glissade
