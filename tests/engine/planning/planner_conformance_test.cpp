// Every planner of the registry keeps the same contract.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/planning/planner.h"
#include "tests/engine/support/test_host.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

std::vector<std::string> plannerIds() {
  std::vector<std::string> ids;
  const PlannerRegistry registry = makePlannerRegistry();
  for (const PlannerEntry& entry : registry.entries()) ids.push_back(entry.id);
  return ids;
}

class PlannerConformance : public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<Planner> make(const Problem& problem, std::uint64_t seed = 1) const {
    return makePlannerRegistry().find(GetParam())->make(problem, seed);
  }
};

TEST_P(PlannerConformance, SolvesTheWindowWithACertifiedPathFromStartToGoal) {
  const Problem problem = windowProblem();
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    TestHost host(problem);
    const auto planner = make(problem, seed);
    ASSERT_TRUE(planner->solve(host)) << "seed " << seed;
    const Path* path = planner->path();
    ASSERT_NE(path, nullptr);
    EXPECT_EQ(path->points.front().q, problem.start);
    EXPECT_EQ(path->points.back().q, std::get<Pose>(problem.goal));
    EXPECT_EQ(path->certificate.status, CertificateStatus::Certified);
    EXPECT_GE(path->certificate.provedClearance, host.values[ParameterId::RequiredClearance]);
    const auto query = problem.world->makeQuery();
    EXPECT_EQ(certifyPath(*query, problem.world->object(), path->configurations(),
                          host.values[ParameterId::RequiredClearance])
                  .status,
              CertificateStatus::Certified);
  }
}

TEST_P(PlannerConformance, CountsAreThoseOfTheRoadmap) {
  const Problem problem = windowProblem();
  TestHost host(problem);
  const auto planner = make(problem);
  ASSERT_TRUE(planner->solve(host));
  const PlannerCounts& counts = planner->counts();
  EXPECT_EQ(counts.nodes, planner->nodes().size());
  EXPECT_EQ(counts.edges, 2 * (planner->edges().size() - planner->droppedEdges().size()));
  // One tree pair, nothing dropped: the identity of the papers' tables.
  ASSERT_EQ(counts.droppedEdges, 0U);
  EXPECT_EQ(counts.edges, 2 * counts.nodes - 2);
  EXPECT_EQ(counts.steps, counts.randomConfigurations + counts.operatorConfigurations + counts.contactConfigurations);
  EXPECT_GT(counts.queries.collision + counts.queries.distance, 0U);
}

TEST_P(PlannerConformance, SameSeedGrowsTheSameRoadmapBitByBitHoweverOftenItIsInterrupted) {
  const Problem problem = windowProblem();
  const auto whole = make(problem, 3);
  TestHost host(problem);
  host.sample = operatorAt(problem, Pose::translation({-0.4, 0.1, 0.05}));
  ASSERT_TRUE(whole->solve(host));
  const auto pieces = make(problem, 3);
  do {
    host.stepsLeft = 1;
  } while (!pieces->solve(host));
  ASSERT_EQ(whole->nodes().size(), pieces->nodes().size());
  for (std::size_t i = 0; i < whole->nodes().size(); ++i) EXPECT_EQ(whole->nodes()[i].q, pieces->nodes()[i].q);
}

TEST_P(PlannerConformance, DifferentSeedsGrowDifferentRoadmaps) {
  const Problem problem = closedProblem();
  std::set<double> seen;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    TestHost host(problem, 20);
    const auto planner = make(problem, seed);
    EXPECT_FALSE(planner->solve(host));
    seen.insert(planner->nodes().back().q.position.x());
  }
  EXPECT_EQ(seen.size(), 4U);
}

TEST_P(PlannerConformance, EveryNodeIsFreeAndEveryEdgeWasCheckedAtItsEnds) {
  const Problem problem = windowProblem();
  TestHost host(problem, 300);
  host.sample = operatorAt(problem, Pose::translation({-0.35, 0.2, 0.1}));
  const auto planner = make(problem, 2);
  planner->solve(host);
  const auto query = problem.world->makeQuery();
  for (const RoadmapNode& node : planner->nodes()) {
    EXPECT_FALSE(query->collides(node.q));
    EXPECT_TRUE(problem.bounds.contains(node.q.position));
  }
  for (const RoadmapEdge& edge : planner->edges()) {
    EXPECT_LT(edge.from, planner->nodes().size());
    EXPECT_LT(edge.to, planner->nodes().size());
    EXPECT_NE(edge.from, edge.to);
  }
}

TEST_P(PlannerConformance, EndsWithoutAPathWhenToldTo) {
  const Problem problem = closedProblem();
  TestHost host(problem, 50);
  const auto planner = make(problem);
  EXPECT_FALSE(planner->solve(host));
  EXPECT_EQ(planner->path(), nullptr);
  EXPECT_EQ(planner->counts().steps, 50U);
}

TEST_P(PlannerConformance, AStopIsSeenInsideAStep) {
  const Problem problem = windowProblem();
  TestHost host(problem);
  StopSource source;
  source.requestStop();
  host.stop = source.token();
  host.stepsLeft = 1;
  const auto planner = make(problem);
  EXPECT_FALSE(planner->solve(host));
  EXPECT_LE(planner->counts().queries.collision, 64U);
}

TEST_P(PlannerConformance, GoesOutWhenTheGoalIsOut) {
  Problem problem = windowProblem();
  problem.goal = GoalOut{};
  problem.bounds = Box3(Vector3::Constant(-5.0), Vector3::Constant(5.0));
  TestHost host(problem);
  const auto planner = make(problem);
  ASSERT_TRUE(planner->solve(host));
  const Vector3 end = planner->path()->points.back().q.position;
  EXPECT_GE(problem.world->obstaclesBox().exteriorDistance(end), problem.world->objectRadius() - 1e-9);
}

std::string testName(const testing::TestParamInfo<std::string>& parameter) {
  std::string name = parameter.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Registry, PlannerConformance, testing::ValuesIn(plannerIds()), testName);

}  // namespace
}  // namespace glissade
