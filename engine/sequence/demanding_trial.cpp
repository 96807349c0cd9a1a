#include "engine/sequence/demanding_trial.h"

#include <algorithm>
#include <set>

#include "engine/sequence/plan_steps.h"

namespace glissade {

DemandingTrial::DemandingTrial(RemovalTrial& inner, const OrderRules& rules, const AssembledProduct& product,
                               const AssemblyPlan* known, const JointRules* joints)
    : ForwardingTrial(inner), rules_(rules), product_(product), joints_(joints) {
  if (known == nullptr) return;
  const auto learn = [&](const std::vector<StepMotion>& motions) {
    for (const StepMotion& motion : motions) {
      const BodyGroup group = groupOf(motion, product);
      if (motion.certified && motion.path.size() > 1) known_[group] = {group, motion.path, motion.method};
    }
  };
  for (const AssemblyStep& step : known->steps) learn(step.motions);
  learn(known->waiting);
}

RemovalAnswer DemandingTrial::tryRemoval(const BodyGroup& group, const BodySet& present, int effort,
                                         const StopToken& stop) {
  if (const auto* motion = rules_.motionOf(group)) return byMotion(*motion, present, stop);
  const auto known = known_.find(group);
  if (effort > 0 && known != known_.end() && known->second.method != kByHand && !isOfJoint(group, present)) {
    if (besideTheEnd(known->second, without(present, group)).empty()) {
      auto removed = inner().certified(group, known->second.path, known->second.method, present, stop);
      if (removed) return std::move(*removed);
    }
    if (stop.stopRequested()) return Refused{{}, true};
  }
  return inner().tryRemoval(group, present, effort, stop);
}

std::vector<BodyGroup> DemandingTrial::groupsAlongLines(const GroupQuestion& question, ThreadTeam& team,
                                                        const StopToken& stop) {
  return inner().groupsAlongLines(question, team, stop);
}

/// The motion has to end outside of the box of all other bodies, as every removal does.
RemovalAnswer DemandingTrial::byMotion(const OrderRules::GivenMotion& motion, const BodySet& present,
                                       const StopToken& stop) {
  const BodySet others = without(present, motion.group);
  const std::vector<std::size_t> beside = besideTheEnd(motion, others);
  std::set<std::size_t> blocking(beside.begin(), beside.end());
  if (blocking.empty()) {
    auto removed = inner().certified(motion.group, motion.path, motion.method, present, stop);
    if (removed) return std::move(*removed);
  }
  if (stop.stopRequested()) return Refused{{}, true};
  for (const std::size_t body : inner().inTheWay(motion.group, motion.path, bodiesIn(others), stop)) {
    blocking.insert(body);
  }
  return Refused{{blocking.begin(), blocking.end()}, stop.stopRequested()};
}

/// Bodies whose boxes the end of the motion does not leave; empty if the motion ends outside of the box of all others.
std::vector<std::size_t> DemandingTrial::besideTheEnd(const OrderRules::GivenMotion& motion,
                                                      const BodySet& others) const {
  const Pose X_end = motion.path.back().q * inverse(motion.path.front().q);
  const Box3 box = boxOf(product_, others);
  const bool isInside = std::any_of(motion.group.begin(), motion.group.end(), [&](std::size_t body) {
    const RigidBody& own = product_.bodies[body];
    return !box.isEmpty() && box.intersects(boundingBox(*own.mesh, X_end * own.X_WB));
  });
  return isInside ? bodiesIn(others) : std::vector<std::size_t>();
}

}  // namespace glissade
