#include "engine/sequence/plan_judge.h"

#include <gtest/gtest.h>

#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

bool allValid(const std::vector<StepJudgement>& judgements) {
  return std::all_of(judgements.begin(), judgements.end(), [](const auto& each) { return each.valid(); });
}

TEST(PlanJudge, AgreesWithThePlanner) {
  const AssembledProduct product = test::lockedDrawer();
  const AssemblyPlan plan = test::planOf(product, "cabinet");
  ASSERT_EQ(test::orderOf(plan), (std::vector<std::string>{"cap", "pin", "drawer"}));
  const auto judgements = judgePlan(plan, product, std::nullopt);
  ASSERT_TRUE(judgements.ok());
  EXPECT_EQ(judgements->size(), 3U);
  EXPECT_TRUE(allValid(*judgements));
}

TEST(PlanJudge, RefusesAnOrderThatIsNotFree) {
  const AssembledProduct product = test::lockedDrawer();
  AssemblyPlan plan = test::planOf(product, "cabinet");
  ASSERT_EQ(plan.steps.size(), 3U);
  std::swap(plan.steps[1], plan.steps[2]);
  const auto judgements = judgePlan(plan, product, std::nullopt);
  ASSERT_TRUE(judgements.ok());
  EXPECT_TRUE((*judgements)[0].valid());
  EXPECT_FALSE((*judgements)[1].valid()) << "the drawer through its pin";
  EXPECT_EQ((*judgements)[1].certificate.nearest.body, static_cast<int>(*product.indexOf("pin")));
}

/// What a step is said not to be after may be there.
TEST(PlanJudge, RefusesAPrecedenceThatLeavesSomethingOut) {
  const AssembledProduct product = test::lockedDrawer();
  AssemblyPlan plan = test::planOf(product, "cabinet");
  ASSERT_EQ(plan.steps.size(), 3U);
  EXPECT_EQ(plan.steps[1].after, std::vector<std::size_t>{1});
  plan.steps[1].after.clear();
  const auto judgements = judgePlan(plan, product, std::nullopt);
  ASSERT_TRUE(judgements.ok());
  EXPECT_TRUE((*judgements)[0].valid());
  EXPECT_FALSE((*judgements)[1].valid()) << "the pin under its cap";
}

TEST(PlanJudge, RefusesAPathThatEndsInsideAndAllowancesOfItsOwn) {
  const AssembledProduct product = test::lockedDrawer();
  AssemblyPlan plan = test::planOf(product, "cabinet");
  ASSERT_EQ(plan.steps.size(), 3U);
  plan.steps[0].path.pop_back();
  plan.steps[1].allowances.push_back({"cabinet", ContactKind::Planar, 0.0, 1e-3, ""});
  const auto judgements = judgePlan(plan, product, std::nullopt);
  ASSERT_TRUE(judgements.ok());
  EXPECT_FALSE((*judgements)[0].endsOutside);
  EXPECT_FALSE((*judgements)[1].allowancesAsFits);
  EXPECT_TRUE((*judgements)[2].valid());
}

}  // namespace
}  // namespace glissade
