#include "engine/sequence/step_precedence.h"

#include <numeric>
#include <set>

#include "engine/sequence/plan_steps.h"

namespace glissade {
namespace {

/// Of the step with this index.
void demandAllEarlier(AssemblyStep& step, std::size_t index) {
  step.after.resize(index);
  std::iota(step.after.begin(), step.after.end(), std::size_t{1});
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
    for (const std::size_t body :
         question.trial.inTheWay(groups[step], plan.steps[step].path, left, host.stopToken())) {
      after.insert(stepOf[body]);
    }
    for (const OrderRule& rule : question.rules.before) {
      const std::size_t first = stepOf[rule.first];
      if (stepOf[rule.then] == step + 1 && first != 0 && first <= step) after.insert(first);
    }
    plan.steps[step].after.assign(after.begin(), after.end());
    if (host.stopToken().stopRequested()) demandAllEarlier(plan.steps[step], step);
  });
}

void demandAllEarlier(AssemblyPlan& plan) {
  for (std::size_t step = 0; step < plan.steps.size(); ++step) demandAllEarlier(plan.steps[step], step);
}

}  // namespace glissade
