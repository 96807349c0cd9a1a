#include "engine/planning/contact/interactive_contact_birrt.h"

#include <gtest/gtest.h>

#include "engine/base/tolerances.h"
#include "tests/engine/support/test_host.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

/// q_device 5 cm in front of the closed wall: nearer than d = 0.15.
const Pose kNearWall = Pose::translation({-0.35, 0.3, 0.2});
const Pose kFarFromWall = Pose::translation({-1.5, 1.0, 1.0});

class Algorithm1 : public testing::Test {
 protected:
  PlannerCounts run(OperatorUse use, double alpha, const Pose& q_device, std::uint64_t steps = 2000) {
    TestHost host(problem, steps);
    EXPECT_TRUE(host.values.set(ParameterId::Alpha, alpha));
    EXPECT_TRUE(host.values.set(ParameterId::ContactDistance, 0.15));
    host.sample = operatorAt(problem, q_device);
    if (moving) host.sample->moves = 1;
    planner = std::make_unique<InteractiveContactBirrt>(problem, 1, use);
    while (host.stepsLeft > 0) {
      const std::uint64_t left = host.stepsLeft;
      host.stepsLeft = 1;
      planner->solve(host);
      host.stepsLeft = left - 1;
      if (moving) ++host.sample->moves;
    }
    return planner->counts();
  }

  Problem problem = closedProblem();
  bool moving = true;  ///< an operator at rest loses authority
  std::unique_ptr<InteractiveContactBirrt> planner;
};

TEST_F(Algorithm1, AlphaIsTheComputersShare) {
  for (const double alpha : {0.1, 0.5, 0.9}) {
    const PlannerCounts counts = run(OperatorUse::GuideAndContact, alpha, kFarFromWall);
    EXPECT_NEAR(static_cast<double>(counts.randomConfigurations) / static_cast<double>(counts.iterations), alpha, 0.04);
    EXPECT_EQ(counts.contactConfigurations, 0U);
  }
}

TEST_F(Algorithm1, AlphaOneIsThePlainBirrt) {
  const PlannerCounts counts = run(OperatorUse::GuideAndContact, 1.0, kNearWall, 500);
  const std::vector<RoadmapNode> interactive = planner->nodes();
  EXPECT_EQ(counts.randomConfigurations, 500U);
  run(OperatorUse::None, 0.0, kNearWall, 500);
  ASSERT_EQ(planner->nodes().size(), interactive.size());
  for (std::size_t i = 0; i < interactive.size(); ++i) EXPECT_EQ(planner->nodes()[i].q, interactive[i].q);
}

TEST_F(Algorithm1, NearAnObstacleNContactSamplesAreShotForEveryOperatorIteration) {
  const PlannerCounts counts = run(OperatorUse::GuideAndContact, 0.0, kNearWall, 1000);
  EXPECT_EQ(counts.operatorConfigurations, 0U);
  EXPECT_EQ(counts.contactConfigurations, 1000U);
  EXPECT_EQ(counts.iterations, 100U);  // N = 10
}

TEST_F(Algorithm1, AtExactlyDThereIsNoContact) {
  TestHost host(problem, 1);
  ASSERT_TRUE(host.values.set(ParameterId::Alpha, 0.0));
  host.sample = operatorAt(problem, kNearWall);
  ASSERT_TRUE(host.values.set(ParameterId::ContactDistance, host.sample->nearest.distance));
  InteractiveContactBirrt birrt(problem, 1, OperatorUse::GuideAndContact);
  birrt.solve(host);
  EXPECT_EQ(birrt.counts().operatorConfigurations, 1U);
  EXPECT_EQ(birrt.counts().contactConfigurations, 0U);
}

TEST_F(Algorithm1, InCollisionTheDeviceIsATargetAndThereIsNoContactMode) {
  const PlannerCounts counts = run(OperatorUse::GuideAndContact, 0.0, Pose::identity(), 50);
  EXPECT_EQ(counts.contactConfigurations, 0U);
  EXPECT_EQ(counts.operatorConfigurations, 50U);
  // Both trees have grown to the wall from either side.
  EXPECT_GE(counts.nodes, 4U);
}

TEST_F(Algorithm1, ContactNodesLieAtTheGap) {
  run(OperatorUse::GuideAndContact, 0.0, kNearWall, 200);
  const auto query = problem.world->makeQuery();
  int contactNodes = 0;
  for (const RoadmapNode& node : planner->nodes()) {
    if (node.author != Author::Contact || node.side != TreeSide::Start) continue;
    ++contactNodes;
    EXPECT_NEAR(query->nearestObstacle(node.q).distance, tolerance::kContactGap * problem.world->objectRadius(), 1e-9);
  }
  EXPECT_GT(contactNodes, 5);
}

TEST_F(Algorithm1, WithoutContactTheDeviceAloneGuides) {
  const PlannerCounts counts = run(OperatorUse::Guide, 0.0, kNearWall, 100);
  EXPECT_EQ(counts.operatorConfigurations, 100U);
}

TEST_F(Algorithm1, ContactFirstPreemptsTheDraw) {
  const PlannerCounts counts = run(OperatorUse::ContactFirst, 1.0, kNearWall, 500);
  EXPECT_EQ(counts.contactConfigurations, 500U);
}

TEST_F(Algorithm1, AnOperatorAtRestDoesNotFloodTheRoadmap) {
  moving = false;
  const PlannerCounts counts = run(OperatorUse::GuideAndContact, 0.0, kNearWall, 5000);
  EXPECT_LE(counts.contactConfigurations, 220U);
  EXPECT_GT(counts.randomConfigurations, 4000U);
}

TEST_F(Algorithm1, AnOperatorWhoTremblesAddsNoNearDuplicates) {
  const PlannerCounts counts = run(OperatorUse::GuideAndContact, 0.0, kFarFromWall, 2000);
  EXPECT_LE(counts.nodes, 10U);
}

}  // namespace
}  // namespace glissade
