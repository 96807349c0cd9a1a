// Requirements for every registered strategy.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/check/verdict_report.h"
#include "engine/files/judged_product.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

class SequenceStrategies : public testing::TestWithParam<std::string> {};

TEST_P(SequenceStrategies, TakesADrawerApartInItsOnlyOrder) {
  const AssemblyPlan plan = test::planOf(test::lockedDrawer(), "cabinet", 1, GetParam());
  EXPECT_EQ(plan.strategy, GetParam());
  EXPECT_EQ(plan.end, PlanEnd::Complete);
  EXPECT_EQ(test::orderOf(plan), (std::vector<BodyId>{"cap", "pin", "drawer"}));
  EXPECT_EQ(plan.staying, std::vector<BodyId>{"cabinet"});
}

TEST_P(SequenceStrategies, EveryStepIsCertifiedForWhatIsThere) {
  const AssembledProduct product = test::lockedDrawer();
  const AssemblyPlan plan = test::planOf(product, "cabinet", 1, GetParam());
  const check::PlanVerdict verdict = judgePlan(plan, product, std::nullopt);
  ASSERT_EQ(verdict.steps.size(), plan.steps.size());
  for (std::size_t i = 0; i < verdict.steps.size(); ++i) {
    EXPECT_TRUE(verdict.steps[i].valid()) << toString(whyInvalid(verdict.steps[i], judgedProduct(product)));
    EXPECT_LE(plan.steps[i].only().proof.afterSteps, i);
    EXPECT_GE(plan.steps[i].only().proof.provedClearance, plan.steps[i].only().proof.required);
  }
}

TEST_P(SequenceStrategies, RefusesInterlockedBodiesWithTheRightBlocker) {
  const AssemblyPlan plan = test::planOf(test::chain(), "one", 1, GetParam());
  EXPECT_EQ(plan.end, PlanEnd::Stuck);
  EXPECT_EQ(test::orderOf(plan), std::vector<BodyId>{"block"});
  ASSERT_EQ(plan.stuck.size(), 1U);
  EXPECT_EQ(plan.stuck[0].body, "other");
  EXPECT_EQ(plan.stuck[0].blockedBy, std::vector<BodyId>{"one"});
}

TEST_P(SequenceStrategies, ThreadsDoNotChangeThePlan) {
  for (const auto& [product, staying] :
       {std::pair{test::lockedDrawer(), BodyId("cabinet")}, std::pair{test::chain(), BodyId("one")}}) {
    const AssemblyPlan one = test::planOf(product, staying, 1, GetParam());
    const AssemblyPlan two = test::planOf(product, staying, 2, GetParam());
    ASSERT_EQ(test::orderOf(one), test::orderOf(two));
    for (std::size_t i = 0; i < one.steps.size(); ++i) {
      EXPECT_EQ(one.steps[i].only().method, two.steps[i].only().method);
      EXPECT_EQ(configurationsOf(one.steps[i].only().path), configurationsOf(two.steps[i].only().path));
    }
  }
}

std::vector<std::string> strategies() {
  std::vector<std::string> ids;
  const SequenceStrategyRegistry registry = makeSequenceStrategyRegistry();
  for (const SequenceStrategyEntry& entry : registry.entries()) ids.push_back(entry.id);
  return ids;
}

INSTANTIATE_TEST_SUITE_P(All, SequenceStrategies, testing::ValuesIn(strategies()), [](const auto& test) {
  std::string name = test.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace glissade
