#include "engine/planning/direct_planner.h"

#include <gtest/gtest.h>

#include "tests/engine/support/test_host.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

Problem straightAhead() {
  Problem problem = windowProblem();
  problem.goal = Pose::translation({1.5, 0.0, 0.0});  // through the middle of the window
  return problem;
}

TEST(LinearPlanner, GoesStraightWhereItIsFree) {
  const Problem problem = straightAhead();
  TestHost host(problem);
  LinearPlanner planner(problem);
  ASSERT_TRUE(planner.solve(host));
  EXPECT_NEAR(planner.path()->length(), 3.0, 1e-9);
  EXPECT_EQ(planner.counts().randomConfigurations, 0U);
}

TEST(LinearPlanner, GivesUpAtOnceWhereItIsBlocked) {
  const Problem problem = closedProblem();
  TestHost host(problem);
  LinearPlanner planner(problem);
  EXPECT_FALSE(planner.solve(host));
  ASSERT_TRUE(planner.failure());
  EXPECT_EQ(planner.failure()->kind, ErrorKind::NoPath);
  EXPECT_LE(planner.counts().steps, 3U);
}

TEST(PotentialField, SlidesRoundABallThatBlocksTheStraightWay) {
  Problem problem = straightAhead();
  RigidBody ball = boxBody("ball", Vector3::Ones(), Pose::translation({0.0, 0.25, 0.1}));
  ball.mesh = std::make_shared<const TriangleMesh>(makeSphere(0.3));
  problem.world = CollisionWorld::build({ball}, std::make_shared<const TriangleMesh>(makeBox({0.4, 0.4, 0.4})));
  TestHost host(problem);
  LinearPlanner linear(problem);
  ASSERT_FALSE(linear.solve(host));
  PotentialFieldPlanner planner(problem);
  ASSERT_TRUE(planner.solve(host));
  EXPECT_EQ(planner.path()->points.back().q, std::get<Pose>(problem.goal));
  EXPECT_GT(planner.path()->length(), 3.0);
  EXPECT_LT(planner.path()->length(), 5.0);
}

TEST(PotentialField, GivesUpInALocalMinimum) {
  const Problem problem = closedProblem();
  TestHost host(problem);
  PotentialFieldPlanner planner(problem);
  EXPECT_FALSE(planner.solve(host));
  ASSERT_TRUE(planner.failure());
  EXPECT_EQ(planner.failure()->kind, ErrorKind::NoPath);
  EXPECT_GT(host.stepsLeft, 0U) << "it went on until it was stopped";
}

}  // namespace
}  // namespace glissade
