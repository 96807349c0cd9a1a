#pragma once

#include <map>

#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/joint_rules.h"
#include "engine/sequence/order_rules.h"
#include "engine/sequence/removal_trial.h"

namespace glissade {

/// Asks another trial, but for bodies that leave by a motion of a person only: these are refused by those in the way of
/// that motion. Where a motion of an earlier plan is known, it is tried before one is searched.
class DemandingTrial final : public RemovalTrial {
 public:
  /// Refers to all but `known`: a plan of the same product, or null. `joints`: of a group in a closed thread a known
  /// motion counts only where it turns; null: there are none.
  DemandingTrial(RemovalTrial& inner, const OrderRules& rules, const AssembledProduct& product,
                 const AssemblyPlan* known, const JointRules* joints = nullptr);

  int efforts() const override { return inner_.efforts(); }
  RemovalAnswer tryRemoval(const BodyGroup& group, const BodySet& present, int effort, const StopToken& stop) override;
  std::vector<BodyGroup> groupsAlongLines(const GroupQuestion& question, ThreadTeam& team,
                                          const StopToken& stop) override;
  std::vector<std::size_t> inTheWay(const BodyGroup& group, const std::vector<PathPoint>& path,
                                    const std::vector<std::size_t>& left, const StopToken& stop) override {
    return inner_.inTheWay(group, path, left, stop);
  }
  std::vector<BodyFit> fitsWith(const BodyGroup& group, const BodySet& others) const override {
    return inner_.fitsWith(group, others);
  }
  std::optional<Removed> certified(const BodyGroup& group, const std::vector<PathPoint>& path,
                                   const std::string& method, const BodySet& present, const StopToken& stop) override {
    return inner_.certified(group, path, method, present, stop);
  }
  std::vector<std::size_t> inTheWayOfTool(const MeshPtr& tool, const std::pair<Pose, Pose>& motion,
                                          const std::vector<std::size_t>& others, const StopToken& stop) override {
    return inner_.inTheWayOfTool(tool, motion, others, stop);
  }
  void learn(const BodyGroup& group, const std::vector<PathPoint>& path) override { inner_.learn(group, path); }

 private:
  bool isOfJoint(const BodyGroup& group, const BodySet& present) const {
    return joints_ != nullptr && !joints_->opened(group, present).empty();
  }
  RemovalAnswer byMotion(const OrderRules::GivenMotion& motion, const BodySet& present, const StopToken& stop);
  std::vector<std::size_t> besideTheEnd(const OrderRules::GivenMotion& motion, const BodySet& others) const;

  RemovalTrial& inner_;
  const OrderRules& rules_;
  const AssembledProduct& product_;
  const JointRules* joints_;
  std::map<BodyGroup, OrderRules::GivenMotion> known_;  ///< of an earlier plan
};

}  // namespace glissade
