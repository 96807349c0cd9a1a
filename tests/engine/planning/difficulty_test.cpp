#include "engine/planning/difficulty/difficulty.h"

#include <gtest/gtest.h>

#include "engine/planning/planner.h"
#include "tests/engine/support/test_host.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

/// The wall of `windowProblem` with a square window, and an object.
Problem windowOf(double width, const TriangleMesh& object = makeBox({0.4, 0.4, 0.4})) {
  Problem problem = windowProblem();
  const double half = 0.5 * width;
  const double side = 2.5 - half;
  const double centre = half + 0.5 * side;
  problem.world = CollisionWorld::build({boxBody("left", {0.2, side, 5.0}, Pose::translation({0.0, -centre, 0.0})),
                                         boxBody("right", {0.2, side, 5.0}, Pose::translation({0.0, centre, 0.0})),
                                         boxBody("below", {0.2, width, side}, Pose::translation({0.0, 0.0, -centre})),
                                         boxBody("above", {0.2, width, side}, Pose::translation({0.0, 0.0, centre}))},
                                        std::make_shared<const TriangleMesh>(object));
  return problem;
}

struct Grown {
  std::vector<RoadmapNode> nodes;
  std::vector<RoadmapEdge> edges;
};

Grown grow(const Problem& problem, std::uint64_t steps, const char* planner = "birrt") {
  TestHost host(problem, steps);
  const auto made = makePlannerRegistry().find(planner)->make(problem, 1);
  EXPECT_FALSE(made->solve(host));
  return {made->nodes(), made->edges()};
}

TEST(Difficulty, TellsHowMuchTooLargeTheObjectIs) {
  const Problem problem = windowOf(0.37);  // 15 mm too narrow on each side
  const ParameterValues parameters(problem.world->objectRadius());
  const Grown grown = grow(problem, 1500);
  const Difficulty difficulty = difficultyOf(problem, grown.nodes, grown.edges, parameters, 1);
  ASSERT_TRUE(difficulty.leastPenetration);
  EXPECT_GE(difficulty.leastPenetration->depth, 0.0149);
  EXPECT_LT(difficulty.leastPenetration->depth, 0.03);
  EXPECT_GE(difficulty.leastPenetration->body, 0);
  EXPECT_LT(std::abs(difficulty.leastPenetration->q.position.x()), 0.35);
  EXPECT_EQ(difficulty.leastPenetration->way.front(), problem.start);
  EXPECT_EQ(difficulty.leastPenetration->way.back(), std::get<Pose>(problem.goal));
}

/// Objects of more than 10,000 triangles had no result.
TEST(Difficulty, TellsItOfAnObjectOfManyTriangles) {
  const TriangleMesh ball = makeSphere(0.2, 5);
  ASSERT_GT(ball.triangles.size(), 20'000U);
  const Problem problem = windowOf(0.38, ball);  // 10 mm too narrow on each side
  const ParameterValues parameters(problem.world->objectRadius());
  const auto least = leastPenetration(problem, parameters, 1);
  ASSERT_TRUE(least);
  EXPECT_GE(least->depth, 0.0099);
  EXPECT_LT(least->depth, 0.02);
}

TEST(Difficulty, NamesTheFrontierAndWhatStandsBetween) {
  const Problem problem = closedProblem();
  const ParameterValues parameters(problem.world->objectRadius());
  const Grown grown = grow(problem, 500);
  PenetrationBudget budget;
  budget.searchWork = 500;
  const Difficulty difficulty = difficultyOf(problem, grown.nodes, grown.edges, parameters, 1, budget);
  ASSERT_TRUE(difficulty.frontier);
  double nearest = 1e9;
  for (const RoadmapNode& a : grown.nodes) {
    for (const RoadmapNode& b : grown.nodes) {
      if (a.side == TreeSide::Start && b.side == TreeSide::Goal) {
        nearest = std::min(nearest, problem.metric().distance(a.q, b.q));
      }
    }
  }
  EXPECT_NEAR(difficulty.frontier->distance, nearest, 1e-9);
  EXPECT_LT(difficulty.frontier->fromStart.position.x(), -0.3);
  EXPECT_GT(difficulty.frontier->fromGoal.position.x(), 0.3);
  EXPECT_EQ(difficulty.frontier->body, 0);
  ASSERT_TRUE(difficulty.tightest);
  EXPECT_EQ(difficulty.tightest->body, 0);
  EXPECT_GE(difficulty.tightest->clearance, 0.0);
  EXPECT_LT(difficulty.tightest->clearance, 0.5);
  EXPECT_FALSE(difficulty.leastPenetration) << "a closed wall does not open";
}

TEST(Difficulty, OneTreeIsComparedWithTheGoalAndAStopEndsIt) {
  const Problem problem = closedProblem();
  const ParameterValues parameters(problem.world->objectRadius());
  const Grown grown = grow(problem, 300, "g");
  StopSource source;
  source.requestStop();
  const Difficulty stopped = difficultyOf(problem, grown.nodes, grown.edges, parameters, 1, {}, source.token());
  EXPECT_FALSE(stopped.leastPenetration);
  PenetrationBudget budget;
  budget.searchWork = 100;
  const Difficulty difficulty = difficultyOf(problem, grown.nodes, grown.edges, parameters, 1, budget);
  ASSERT_TRUE(difficulty.frontier);
  EXPECT_EQ(difficulty.frontier->fromGoal, std::get<Pose>(problem.goal));
}

TEST(Difficulty, TheSameSeedTellsTheSame) {
  const Problem problem = windowOf(0.38);
  const ParameterValues parameters(problem.world->objectRadius());
  const auto once = leastPenetration(problem, parameters, 4);
  const auto again = leastPenetration(problem, parameters, 4);
  ASSERT_TRUE(once && again);
  EXPECT_EQ(once->depth, again->depth);
  EXPECT_EQ(once->way, again->way);
}

}  // namespace
}  // namespace glissade
