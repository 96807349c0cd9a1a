#include "engine/sequence/step_precedence.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/files/judged_product.h"
#include "engine/sequence/plan_steps.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

/// Two boxes that touch each other and their base.
AssembledProduct neighbours() {
  return test::productOf({boxBody("base", {1.0, 1.0, 0.1}, Pose::identity()),
                          boxBody("one", {0.2, 0.2, 0.2}, Pose::translation({-0.1, 0.0, 0.15})),
                          boxBody("two", {0.2, 0.2, 0.2}, Pose::translation({0.1, 0.0, 0.15}))},
                         true);
}

std::vector<BodyId> allowedAgainst(const AssemblyStep& step) {
  std::vector<BodyId> bodies;
  for (const Allowance& each : step.only().allowances) bodies.push_back(each.body);
  std::sort(bodies.begin(), bodies.end());
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  return bodies;
}

/// "one" leaves, then "two"; both motions were found while all bodies were there. `rules`: steps that have to wait.
AssemblyPlan planWith(const AssembledProduct& product, const OrderRules& rules) {
  const ProductFits fits = test::fitsOf(product);
  MotionTrial trial(product, fits, 1);
  const SequenceQuestion question{product, {true, false, false}, 1, trial, nullptr, rules};
  test::QuietHost host;
  AssemblyPlan plan;
  for (const BodyId& id : std::vector<BodyId>{"one", "two"}) {
    const BodyGroup group{product.indexOf(id)};
    const RemovalAnswer answer = trial.tryRemoval(group, question.initial(), 0, {});
    const std::size_t before = plan.steps.size();
    plan.steps.push_back(
        {{makeMotion(group, std::get<Removed>(answer), question, question.initial(), before)}, before + 1});
  }
  addPrecedence(plan, question, host);
  return plan;
}

using Bodies = std::vector<BodyId>;

TEST(StepPrecedence, NothingIsAllowedAgainstWhatHasLeftInAnyOrder) {
  const AssembledProduct product = neighbours();
  OrderRules rules;
  rules.before.push_back({product.indexOf("one"), product.indexOf("two")});
  const AssemblyPlan plan = planWith(product, rules);
  EXPECT_EQ(plan.steps[1].after, std::vector<std::size_t>{1});
  EXPECT_EQ(allowedAgainst(plan.steps[0]), (Bodies{"base", "two"}));
  EXPECT_EQ(allowedAgainst(plan.steps[1]), Bodies{"base"});
  const check::PlanVerdict judged = judgePlan(plan, product, std::nullopt);
  EXPECT_TRUE(judged.steps[1].valid()) << toString(judged.steps[1].againstDemand);
}

TEST(StepPrecedence, WhatMayLeaveLaterIsAllowedFor) {
  const AssemblyPlan plan = planWith(neighbours(), {});
  EXPECT_TRUE(plan.steps[1].after.empty());
  EXPECT_EQ(allowedAgainst(plan.steps[1]), (Bodies{"base", "one"}));
}

}  // namespace
}  // namespace glissade
