#pragma once

#include <map>

#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/forwarding_trial.h"
#include "engine/sequence/joint_rules.h"
#include "engine/sequence/order_rules.h"

namespace glissade {

/// Asks another trial, but for bodies that leave by a motion of a person only: these are refused by those in the way of
/// that motion. Where a motion of an earlier plan is known, it is tried before one is searched.
class DemandingTrial final : public ForwardingTrial {
 public:
  /// Refers to all but `known`: a plan of the same product, or null. `joints`: of a group in a closed thread a known
  /// motion counts only where it turns; null: there are none.
  DemandingTrial(RemovalTrial& inner, const OrderRules& rules, const AssembledProduct& product,
                 const AssemblyPlan* known, const JointRules* joints = nullptr);

  RemovalAnswer tryRemoval(const BodyGroup& group, const BodySet& present, int effort, const StopToken& stop) override;
  std::vector<BodyGroup> groupsAlongLines(const GroupQuestion& question, ThreadTeam& team,
                                          const StopToken& stop) override;

 private:
  bool isOfJoint(const BodyGroup& group, const BodySet& present) const {
    return joints_ != nullptr && !joints_->opened(group, present).empty();
  }
  RemovalAnswer byMotion(const OrderRules::GivenMotion& motion, const BodySet& present, const StopToken& stop);
  std::vector<std::size_t> besideTheEnd(const OrderRules::GivenMotion& motion, const BodySet& others) const;

  const OrderRules& rules_;
  const AssembledProduct& product_;
  const JointRules* joints_;
  std::map<BodyGroup, OrderRules::GivenMotion> known_;  ///< of an earlier plan
};

}  // namespace glissade
