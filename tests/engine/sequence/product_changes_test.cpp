#include "engine/sequence/product_changes.h"

#include <gtest/gtest.h>

#include "engine/files/judged_product.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

/// A copy of the product in which one body has another mesh or pose.
AssembledProduct with(AssembledProduct product, const BodyId& id, const RigidBody& body) {
  RigidBody& changed = product.bodies[product.indexOf(id)];
  changed.mesh = body.mesh;
  changed.X_WB = body.X_WB;
  return product;
}

TEST(ProductChanges, TheSameProductHasNone) {
  const ProductChanges changes = changesBetween(test::lockedDrawer(), test::lockedDrawer());
  EXPECT_TRUE(changes.none());
  EXPECT_EQ(changes.unchanged, 4U);
}

TEST(ProductChanges, EachKindIsFound) {
  const AssembledProduct before = test::lockedDrawer();
  const Pose aside{Vector3(0.01, 0.0, 0.22), Quaternion(Eigen::AngleAxisd(0.3, Vector3::UnitZ()))};
  const AssembledProduct moved = with(before, "pin", boxBody("pin", {0.08, 0.08, 0.6}, aside));
  const ProductChanges ofMoved = changesBetween(before, moved);
  ASSERT_EQ(ofMoved.changed.size(), 1U);
  EXPECT_NEAR(ofMoved.changed[0].moved, 0.01, 1e-12);
  EXPECT_NEAR(ofMoved.changed[0].turned, 0.3, 1e-9);
  EXPECT_EQ(ofMoved.changed[0].reshaped, 0.0);

  const AssembledProduct longer =
      with(before, "pin", boxBody("pin", {0.08, 0.08, 0.62}, Pose::translation({0.0, 0.0, 0.23})));
  const ProductChanges ofLonger = changesBetween(before, longer);
  ASSERT_EQ(ofLonger.changed.size(), 1U);
  EXPECT_NEAR(ofLonger.changed[0].reshaped, 0.02, 1e-9);

  AssembledProduct renamed = before;
  renamed.bodies[2].id = "bolt";
  renamed.bodies[2].name = "bolt";
  const ProductChanges ofRenamed = changesBetween(before, renamed);
  EXPECT_TRUE(ofRenamed.came.empty() && ofRenamed.went.empty());
  EXPECT_EQ(ofRenamed.renamed, (std::vector<std::pair<std::size_t, std::size_t>>{{2, 2}}));

  AssembledProduct fewer = before;
  fewer.bodies.pop_back();
  EXPECT_EQ(changesBetween(before, fewer).went, std::vector<std::size_t>{3});
  EXPECT_EQ(changesBetween(fewer, before).came, std::vector<std::size_t>{3});
}

TEST(ProductChanges, AShapeThatChangesByLessThanItsDeflectionIsFoundByItsTriangles) {
  AssembledProduct before = test::lockedDrawer();
  before.deflections.assign(4, 1e-3);
  AssembledProduct now = with(before, "pin", boxBody("pin", {0.0801, 0.08, 0.6}, before.bodies[2].X_WB));
  EXPECT_EQ(changesBetween(before, now).changed.size(), 1U);
}

TEST(CarriedPlan, StepsThatStillHoldAreJudgedValid) {
  const AssembledProduct before = test::lockedDrawer();
  const AssemblyPlan plan = test::planOf(before, "cabinet");
  AssembledProduct now = before;
  now.bodies.push_back(boxBody("roof", {3.0, 3.0, 0.1}, Pose::translation({0.0, 0.0, 2.0})));
  const CarriedPlan carried = carriedTo(now, plan);
  EXPECT_EQ(carried.from, (std::vector<std::size_t>{0, 1, 2}));
  const check::PlanVerdict verdict = judgePlan(carried.plan, now, std::nullopt);
  // The cap and the pin leave upwards, through the roof; the drawer leaves sideways, farther than the roof reaches.
  ASSERT_EQ(test::orderOf(plan), (std::vector<BodyId>{"cap", "pin", "drawer"}));
  EXPECT_FALSE(verdict.steps[0].valid());
  EXPECT_FALSE(verdict.steps[1].valid());
  EXPECT_TRUE(verdict.steps[2].valid());
}

TEST(CarriedPlan, StepsOfBodiesThatWentAreLeftOut) {
  const AssembledProduct before = test::lockedDrawer();
  AssemblyPlan plan = test::planOf(before, "cabinet");
  ASSERT_EQ(plan.steps[2].only().body, "drawer");
  plan.steps[2].after = {1, 2};
  plan.steps[2].only().falling = {"cap"};
  AssembledProduct now = before;
  now.bodies.pop_back();
  const CarriedPlan carried = carriedTo(now, plan);
  EXPECT_EQ(test::orderOf(carried.plan), (std::vector<BodyId>{"pin", "drawer"}));
  EXPECT_EQ(carried.from, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(carried.plan.steps[1].after, std::vector<std::size_t>{1});
  EXPECT_TRUE(carried.plan.steps[1].only().falling.empty());
  EXPECT_EQ(carried.plan.bodies.size(), 3U);
  for (const check::StepVerdict& step : judgePlan(carried.plan, now, std::nullopt).steps) EXPECT_TRUE(step.valid());
}

/// Two motions of one step, as of a fastener stack: the one whose body is there stays.
TEST(CarriedPlan, AStepKeepsTheMotionsOfWhatIsThere) {
  const AssembledProduct before = test::lockedDrawer();
  AssemblyPlan plan = test::planOf(before, "cabinet");
  ASSERT_EQ(test::orderOf(plan), (std::vector<BodyId>{"cap", "pin", "drawer"}));
  plan.steps[0].motions.push_back(plan.steps[1].only());
  plan.steps.erase(plan.steps.begin() + 1);
  plan.steps[1].after = {1};
  AssembledProduct now = before;
  now.bodies.pop_back();
  const CarriedPlan carried = carriedTo(now, plan);
  EXPECT_EQ(test::orderOf(carried.plan), (std::vector<BodyId>{"pin", "drawer"}));
  EXPECT_EQ(carried.from, (std::vector<std::size_t>{0, 1}));
  for (const check::StepVerdict& step : judgePlan(carried.plan, now, std::nullopt).steps) EXPECT_TRUE(step.valid());
}

}  // namespace
}  // namespace glissade
