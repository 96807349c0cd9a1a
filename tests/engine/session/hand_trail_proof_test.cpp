// Attacks the way of a hand: whatever the hand does, each edge of its trees passes the independent judge.
#include <gtest/gtest.h>

#include "engine/operator/operator_input.h"
#include "engine/planning/contact/hand_trail.h"
#include "tests/engine/support/forbidden_boxes.h"
#include "tests/engine/support/independent_check.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/test_host.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

class HandTrailProof : public testing::TestWithParam<std::uint64_t> {
 protected:
  HandTrailProof() {
    problem.world = problem.world->withForbidden(space);
    query = problem.world->makeQuery();
    roadmap.addRoot({problem.start, Author::Computer, TreeSide::Start});
    roadmap.addRoot({std::get<Pose>(problem.goal), Author::Computer, TreeSide::Goal});
  }

  void moveTo(const Pose& q) { trail.follow(operatorAt(problem, q), roadmap, *query, host); }

  /// Small motions, each in the direction of the one before or in a new one, and now and then a jump.
  void moveAtRandom(double step, double jumps, int motions) {
    Pose q = problem.start;
    Twist motion;
    for (int i = 0; i < motions; ++i) {
      if (i % 8 == 0) motion = {step * randomPose(random, 1.0).position, 0.5 * step * randomPose(random, 1.0).position};
      q = random.uniform() < jumps ? randomPose(random, 2.2) : integrate(q, motion, unlimited, 1.0);
      moveTo(q);
    }
  }

  /// Number of the edges, all of which keep what is demanded.
  std::size_t judgedEdges() const {
    const IndependentCheck judge(problem.world->obstacles(), problem.world->object());
    const double required = host.values[ParameterId::RequiredClearance];
    for (const RoadmapEdge& edge : roadmap.edges()) {
      const std::vector<Pose> piece{roadmap.nodes()[edge.from].q, roadmap.nodes()[edge.to].q};
      EXPECT_EQ(judge.check(piece, {{required, false}}).status, CertificateStatus::Certified);
      if (space->regions()) {
        EXPECT_EQ(test::metBy(piece, space->regions()->places(), test::forbiddenMarginOf(*problem.world)), "");
      }
    }
    for (const RoadmapNode& node : roadmap.nodes()) EXPECT_TRUE(problem.bounds.contains(node.q.position));
    return roadmap.edges().size();
  }

  /// True if no configuration of the hand is joined to the start.
  bool isSeparate(const Pose& q) const {
    for (std::uint32_t i = 1; i < roadmap.nodes().size(); ++i) {
      if (roadmap.connected(0, i) && problem.metric().distance(roadmap.nodes()[i].q, q) < 1e-9) return false;
    }
    return true;
  }

  std::shared_ptr<ForbiddenSpace> space = std::make_shared<ForbiddenSpace>();
  Problem problem = windowProblem();
  std::unique_ptr<CollisionQuery> query;
  TestHost host{problem};
  RoadmapGraph roadmap{problem.metric()};
  HandTrail trail{problem};
  RandomStream random{GetParam(), "hand"};
  Box3 unlimited{Vector3::Constant(-10.0), Vector3::Constant(10.0)};
};

INSTANTIATE_TEST_SUITE_P(Seeds, HandTrailProof, testing::Range<std::uint64_t>(1, 6));

TEST_P(HandTrailProof, AHandThatPassesThroughWallsLeavesNoEdgeThere) {
  moveAtRandom(0.3, 0.05, 400);
  EXPECT_GT(judgedEdges(), 50U);
}

TEST_P(HandTrailProof, ASlowHandThatPassesThroughWallsLeavesNoEdgeThere) {
  moveAtRandom(0.03, 0.02, 600);
  EXPECT_GT(judgedEdges(), 20U);
}

TEST_P(HandTrailProof, AHandLeavesNoEdgeInAForbiddenPlace) {
  const auto forbid = [&](const Vector3& least, const Vector3& most) {
    ForbiddenPlaces places{{"P1", {Box3(least, most)}}};
    space->set(std::make_shared<const ForbiddenRegions>(places, test::forbiddenMarginOf(*problem.world)));
  };
  forbid({-0.1, -0.5, -0.5}, {0.1, 0.5, 0.5});
  moveTo(Pose::translation({0.0, 0.1, 0.1}));  // a jump into the place
  EXPECT_EQ(roadmap.nodes().size(), 2U);
  moveAtRandom(0.3, 0.3, 400);
  EXPECT_GT(judgedEdges(), 50U);
  EXPECT_TRUE(!roadmap.connected(0, 1)) << "the window is forbidden";
}

TEST_P(HandTrailProof, AJumpOverAWallIsNoWay) {
  problem = closedProblem();
  query = problem.world->makeQuery();
  for (int i = 0; i < 20; ++i) {
    moveTo(Pose::translation({-1.0 - 0.01 * i, 0.0, 0.0}));
    const Pose beyond = Pose::translation({1.0 + 0.01 * i, 0.5, 0.0});
    moveTo(beyond);
    EXPECT_TRUE(isSeparate(beyond));
  }
  EXPECT_FALSE(roadmap.connected(0, 1));
  EXPECT_GT(judgedEdges(), 20U);
}

TEST_P(HandTrailProof, TheWayKeepsTheClearanceThatIsRequired) {
  ASSERT_TRUE(host.values.set(ParameterId::RequiredClearance, 0.03));
  moveAtRandom(0.1, 0.1, 600);
  EXPECT_GT(judgedEdges(), 20U);
}

TEST_P(HandTrailProof, AHandThatIsRefusedEverywhereAddsFewNodes) {
  ASSERT_TRUE(host.values.set(ParameterId::RequiredClearance, 0.03));
  for (int i = 0; i < 1000; ++i) moveTo(Pose::translation({-0.32, 0.8 + 1e-3 * i, 0.0}));  // 2 cm off the wall
  EXPECT_EQ(roadmap.nodes().size(), 2U);
}

}  // namespace
}  // namespace glissade
