#include "engine/sequence/step_precedence.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "engine/sequence/plan_steps.h"

namespace glissade {
namespace {

/// Lets the step with this index depend on all earlier ones.
void demandAllEarlier(AssemblyStep& step, std::size_t index) {
  step.after.resize(index);
  std::iota(step.after.begin(), step.after.end(), std::size_t{1});
}

bool isStated(const StepMotion& motion, const Fit& fit) {
  return std::any_of(motion.allowances.begin(), motion.allowances.end(), [&](const Allowance& each) {
    const BodyId& moving = each.moving.empty() ? motion.body : each.moving;
    return each.body == fit.body && moving == fit.moving && each.yields == fit.yields;
  });
}

/// Adds allowances against bodies that leave earlier in the plan and may leave later in another order; removes those
/// against bodies that have left in every order.
void stateAllowancesOfAllOrders(AssemblyPlan& plan, const std::vector<BodyGroup>& groups,
                                const SequenceQuestion& question) {
  const AssembledProduct& product = question.product;
  const std::vector<std::set<std::size_t>> before = allBefore(plan.steps);
  for (std::size_t step = 0; step < plan.steps.size(); ++step) {
    BodySet others(product.bodies.size(), false);
    std::set<BodyId> left;
    for (std::size_t earlier = 0; earlier < step; ++earlier) {
      const bool isBefore = before[step].count(earlier + 1) != 0;
      for (const std::size_t body : groups[earlier]) {
        others[body] = !isBefore;
        if (isBefore) left.insert(product.bodies[body].id);
      }
    }
    StepMotion& motion = plan.steps[step].only();
    std::erase_if(motion.allowances, [&](const Allowance& each) { return left.count(each.body) != 0; });
    if (!motion.certified) continue;
    std::vector<Fit> fits = question.trial.fitsWith(groups[step], others);
    std::erase_if(fits, [&](const Fit& fit) { return isStated(motion, fit); });
    addAllowances(motion, groups[step], fits, product);
  }
}

/// Adds the earlier steps that open the joints of step `number`: a thread comes apart by the earlier of the two steps,
/// and a clamped part stays until then. `stepOf`: number of the step of each body, from 1; 0: it does not leave.
void addJointPrecedence(const JointRules& rules, const std::vector<std::size_t>& stepOf, std::size_t number,
                        std::set<std::size_t>& after) {
  const auto addEarlier = [&](std::size_t step) {
    if (step != 0 && step < number) after.insert(step);
  };
  for (const Joint& joint : rules.joints()) {
    const bool screwed = isScrewed(joint.kind);
    if (!screwed && joint.kind != JointKind::Flexible) continue;
    const std::size_t own = stepOf[joint.body];
    for (const std::size_t other : joint.others) {
      if (stepOf[other] == number) addEarlier(own);
      if (own == number && screwed) addEarlier(stepOf[other]);
    }
    for (const std::size_t clamped : joint.clamped) {
      if (stepOf[clamped] != number) continue;
      addEarlier(own);
      if (own != 0 && own < number) continue;
      for (const std::size_t other : joint.others) addEarlier(stepOf[other]);
    }
  }
}

/// A flexible body, which has no proof, leaves after the earlier bodies whose boxes meet its box.
void addFlexiblePrecedence(std::size_t step, const std::vector<BodyGroup>& groups, const AssembledProduct& product,
                           std::set<std::size_t>& after) {
  BodySet own(product.bodies.size(), false);
  for (const std::size_t body : groups[step]) own[body] = true;
  const Box3 box = boxOf(product, own);
  for (std::size_t earlier = 0; earlier < step; ++earlier) {
    BodySet others(product.bodies.size(), false);
    for (const std::size_t body : groups[earlier]) others[body] = true;
    if (box.intersects(boxOf(product, others))) after.insert(earlier + 1);
  }
}

}  // namespace

void addPrecedence(AssemblyPlan& plan, const SequenceQuestion& question, SequenceHost& host) {
  std::vector<BodyGroup> groups;
  std::vector<std::size_t> stepOf(question.product.bodies.size(), 0);
  for (std::size_t step = 0; step < plan.steps.size(); ++step) {
    BodyGroup group = groupOf(plan.steps[step], question.product);
    for (const std::size_t body : group) stepOf[body] = step + 1;
    groups.push_back(std::move(group));
  }
  host.team().run(groups.size(), [&](std::size_t step) {
    std::vector<std::size_t> left;
    for (std::size_t earlier = 0; earlier < step; ++earlier) {
      left.insert(left.end(), groups[earlier].begin(), groups[earlier].end());
    }
    std::set<std::size_t> after;
    const StepMotion& motion = plan.steps[step].only();
    if (motion.certified) {
      for (const std::size_t body : question.trial.inTheWay(groups[step], motion.path, left, host.stopToken())) {
        after.insert(stepOf[body]);
      }
    } else {
      addFlexiblePrecedence(step, groups, question.product, after);
    }
    if (question.joints != nullptr) addJointPrecedence(*question.joints, stepOf, step + 1, after);
    for (const OrderRule& rule : question.rules.before) {
      const std::size_t first = stepOf[rule.first];
      if (stepOf[rule.then] == step + 1 && first != 0 && first <= step) after.insert(first);
    }
    plan.steps[step].after.assign(after.begin(), after.end());
    if (host.stopToken().stopRequested()) demandAllEarlier(plan.steps[step], step);
  });
  stateAllowancesOfAllOrders(plan, groups, question);
}

std::vector<std::set<std::size_t>> allBefore(const std::vector<AssemblyStep>& steps) {
  std::vector<std::set<std::size_t>> before;
  for (const AssemblyStep& step : steps) {
    std::set<std::size_t> own(step.after.begin(), step.after.end());
    for (const std::size_t each : step.after) own.insert(before[each - 1].begin(), before[each - 1].end());
    before.push_back(std::move(own));
  }
  return before;
}

void demandAllEarlier(AssemblyPlan& plan) {
  for (std::size_t step = 0; step < plan.steps.size(); ++step) demandAllEarlier(plan.steps[step], step);
}

}  // namespace glissade
