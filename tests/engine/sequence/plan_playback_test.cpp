#include "engine/sequence/plan_playback.h"

#include <gtest/gtest.h>

#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

double distance(const Pose& a, const Pose& b) {
  return (a.position - b.position).norm() + angleBetween(a.orientation, b.orientation);
}

TEST(PlanPlayback, BeginsAssembledAndEndsWithAllBodiesAtTheEndsOfTheirPaths) {
  const AssembledProduct product = test::lockedDrawer();
  const AssemblyPlan plan = test::planOf(product, "cabinet");
  const PlanPlayback playback(product, plan);
  ASSERT_EQ(playback.steps(), 3U);
  for (const PlayedBody& body : playback.at(0.0)) {
    EXPECT_LT(distance(body.moved, Pose::identity()), 1e-12);
    EXPECT_FALSE(body.left || body.moves);
  }
  const auto end = playback.at(3.0);
  for (const AssemblyStep& step : plan.steps) {
    const std::size_t body = product.indexOf(step.only().body);
    EXPECT_TRUE(end[body].left);
    EXPECT_LT(distance(end[body].moved * step.only().path.front().q, step.only().path.back().q), 1e-9);
  }
  EXPECT_FALSE(end[product.indexOf("cabinet")].left);
}

TEST(PlanPlayback, OneStepIsUnderWayAtATime) {
  const AssembledProduct product = test::lockedDrawer();
  const AssemblyPlan plan = test::planOf(product, "cabinet");
  const PlanPlayback playback(product, plan);
  for (double time = 0.05; time < 3.0; time += 0.1) {
    const auto bodies = playback.at(time);
    int moving = 0;
    int left = 0;
    for (const PlayedBody& body : bodies) {
      moving += body.moves ? 1 : 0;
      left += body.left ? 1 : 0;
    }
    EXPECT_EQ(moving, 1) << time;
    EXPECT_EQ(left, static_cast<int>(time)) << time;
  }
}

/// Cap and pin are one step: each has half of its time.
TEST(PlanPlayback, TheMotionsOfAStepFollowEachOther) {
  const AssembledProduct product = test::lockedDrawer();
  AssemblyPlan plan = test::planOf(product, "cabinet");
  ASSERT_EQ(plan.steps.size(), 3U);
  plan.steps[0].motions.push_back(plan.steps[1].only());
  plan.steps.erase(plan.steps.begin() + 1);
  const PlanPlayback playback(product, plan);
  ASSERT_EQ(playback.steps(), 2U);
  const std::size_t cap = product.indexOf("cap");
  const std::size_t pin = product.indexOf("pin");
  const auto early = playback.at(0.25);
  EXPECT_TRUE(early[cap].moves);
  EXPECT_FALSE(early[pin].moves);
  const auto late = playback.at(0.75);
  EXPECT_TRUE(late[cap].left);
  EXPECT_TRUE(late[pin].moves);
  const PlayedMotion played = playedMotionAt(0.75, plan);
  EXPECT_EQ(played.motion, 1U);
  EXPECT_DOUBLE_EQ(played.share, 0.5);
  EXPECT_DOUBLE_EQ(played.time(plan), 0.75);
}

TEST(PlanPlayback, AGroupMovesAsOne) {
  const AssembledProduct product = test::lockedDrawer();
  AssemblyPlan plan = test::planOf(product, "cabinet");
  ASSERT_EQ(plan.steps.size(), 3U);
  plan.steps[1].only().with = {plan.steps[0].only().body};
  plan.steps.erase(plan.steps.begin());
  const auto bodies = PlanPlayback(product, plan).at(0.4);
  const Pose& pin = bodies[product.indexOf("pin")].moved;
  EXPECT_GT(pin.position.norm(), 0.1);
  EXPECT_LT(distance(pin, bodies[product.indexOf("cap")].moved), 1e-12);
}

}  // namespace
}  // namespace glissade
