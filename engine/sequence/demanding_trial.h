#pragma once

#include <map>

#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/forwarding_trial.h"
#include "engine/sequence/joint_rules.h"
#include "engine/sequence/order_rules.h"

namespace glissade {

/// Forwards to another trial, except for bodies that leave by the motion of a person only: the bodies in the way of
/// that motion refuse the removal. A motion of an earlier plan is tried before a new one is searched.
class DemandingTrial final : public ForwardingTrial {
 public:
  /// Refers to all arguments except `known`, which is a plan of the same product or null. `joints`: for a group in a
  /// closed thread, a known motion counts only if it turns; null: there are none.
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
  std::map<BodyGroup, OrderRules::GivenMotion> known_;  ///< motions of the earlier plan
};

}  // namespace glissade
