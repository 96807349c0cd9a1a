#include "engine/sequence/plan_bodies.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace glissade {
namespace {

/// The id in the product of each body of the plan; empty if a body has none, or two bodies have the same.
std::map<BodyId, BodyId> idsInProduct(const AssembledProduct& product, const AssemblyPlan& plan) {
  std::map<std::string, BodyId> byName;
  for (const RigidBody& body : product.bodies) byName.emplace(body.name, body.id);
  for (const RigidBody& body : product.bodies) byName[body.id.text()] = body.id;
  std::map<BodyId, BodyId> ids;
  std::set<BodyId> used;
  for (const BodyId& body : plan.bodies) {
    const auto found = byName.find(body.text());
    if (found == byName.end() || !used.insert(found->second).second) return {};
    ids.emplace(body, found->second);
  }
  return ids;
}

/// Replaces ids by those of the product. Names that are no ids stay: demands may name bodies by the ends of their ids.
class Renaming {
 public:
  explicit Renaming(const std::map<BodyId, BodyId>& ids) : ids_(ids) {}

  void one(BodyId& id) const {
    const auto known = ids_.find(id);
    if (known != ids_.end()) id = known->second;
  }
  void one(std::string& name) const {
    const auto known = ids_.find(BodyId(name));
    if (known != ids_.end()) name = known->second.text();
  }
  template <class Named>
  void all(std::vector<Named>& list) const {
    for (Named& each : list) one(each);
  }
  void step(AssemblyStep& step) const {
    for (StepMotion& each : step.motions) motion(each);
    for (StepViolation& violation : step.violates) all(violation.bodies);
  }
  void motion(StepMotion& motion) const {
    one(motion.body);
    all(motion.with);
    all(motion.falling);
    all(motion.tool.blockedBy);
    one(motion.tool.turned);
    one(motion.tool.held);
    one(motion.proof.nearest);
    for (Allowance& allowance : motion.allowances) {
      one(allowance.body);
      one(allowance.moving);
    }
    for (StepJoint& joint : motion.joints) {
      one(joint.body);
      all(joint.others);
      all(joint.clamped);
    }
  }
  void line(SubassemblyLine& line) const {
    all(line.bodies);
    all(line.staying);
    for (AssemblyStep& each : line.steps) step(each);
    for (StuckBody& each : line.stuck) stuck(each);
    for (SubassemblyLine& each : line.lines) this->line(each);
  }
  void stuck(StuckBody& stuck) const {
    one(stuck.body);
    all(stuck.blockedBy);
  }
  void demands(SequenceDemands& demands) const {
    for (auto& group : demands.together) all(group);
    for (auto& [first, then] : demands.before) {
      one(first);
      one(then);
    }
    for (DemandedPlace& place : demands.places) all(place.bodies);
    for (DemandedMotion& motion : demands.motions) all(motion.bodies);
    for (ForbiddenDirection& direction : demands.forbidden) one(direction.body);
    all(demands.stay);
    all(demands.fragile);
    for (auto* weights : {&demands.densities, &demands.masses}) {
      for (auto& each : *weights) one(each.first);
    }
    for (auto* texts : {&demands.tools, &demands.fasteners}) {
      for (auto& each : *texts) one(each.first);
    }
    std::map<std::string, Attributes> attributes;
    for (JointEdit& edit : demands.joints) {
      one(edit.key.body);
      all(edit.key.others);
    }
    for (auto& [id, own] : demands.attributes) {
      std::string name = id;
      one(name);
      attributes[name] = own;
    }
    demands.attributes = std::move(attributes);
  }

 private:
  const std::map<BodyId, BodyId>& ids_;
};

void addMotions(const std::vector<AssemblyStep>& steps, const std::vector<SubassemblyLine>& lines,
                std::vector<const StepMotion*>& all) {
  for (const AssemblyStep& step : steps) {
    for (const StepMotion& motion : step.motions) all.push_back(&motion);
  }
  for (const SubassemblyLine& line : lines) addMotions(line.steps, line.lines, all);
}

}  // namespace

std::vector<std::size_t> bodiesOf(const AssemblyStep& step, const AssembledProduct& product) {
  return product.indicesOf(step.bodies());
}

std::vector<const StepMotion*> allMotionsOf(const AssemblyPlan& plan) {
  std::vector<const StepMotion*> all;
  addMotions(plan.steps, plan.lines, all);
  return all;
}

std::vector<const StepMotion*> motionsOf(const AssemblyStep& step, PlanOrder order) {
  std::vector<const StepMotion*> motions;
  for (const StepMotion& motion : step.motions) motions.push_back(&motion);
  if (order == PlanOrder::Assembly) std::reverse(motions.begin(), motions.end());
  return motions;
}

std::vector<Allowance> allowancesInOrder(const std::vector<AssemblyStep>& steps, std::size_t at,
                                         const StepMotion& motion) {
  std::set<BodyId> left;
  const auto leave = [&](const std::vector<BodyId>& bodies) { left.insert(bodies.begin(), bodies.end()); };
  for (std::size_t earlier = 0; earlier < at; ++earlier) leave(steps[earlier].bodies());
  for (const StepMotion* earlier = steps[at].motions.data(); earlier != &motion; ++earlier) leave(earlier->bodies());
  std::vector<Allowance> there = motion.allowances;
  std::erase_if(there, [&](const Allowance& each) { return left.count(each.body) != 0; });
  return there;
}

std::optional<AssemblyPlan> planAbout(const AssembledProduct& product, const AssemblyPlan& plan) {
  if (plan.bodies.size() != product.bodies.size()) return std::nullopt;
  const auto ids = idsInProduct(product, plan);
  if (ids.size() != plan.bodies.size()) return std::nullopt;
  const Renaming rename(ids);
  AssemblyPlan renamed = plan;
  for (std::size_t i = 0; i < renamed.bodies.size(); ++i) renamed.bodies[i] = product.bodies[i].id;
  rename.all(renamed.staying);
  for (AssemblyStep& step : renamed.steps) rename.step(step);
  for (StepMotion& motion : renamed.waiting) rename.motion(motion);
  for (RefusedRemoval& refused : renamed.refusals) {
    rename.one(refused.body);
    rename.all(refused.with);
    rename.all(refused.blockedBy);
  }
  for (StuckBody& stuck : renamed.stuck) rename.stuck(stuck);
  for (SubassemblyLine& line : renamed.lines) rename.line(line);
  rename.demands(renamed.demands);
  return renamed;
}

}  // namespace glissade
