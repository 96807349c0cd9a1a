// Every planner of the registries keeps the same contract.
#include "tests/engine/planning/planner_conformance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/engine/support/test_host.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

/// True for planners with one tree pair, which paper 1's tables count.
bool growsOneTreePair(const std::string& id) { return id.find("birrt") != std::string::npos; }

class PlannerConformance : public testing::TestWithParam<PlannerUnderTest> {
 protected:
  std::unique_ptr<Planner> make(const Problem& problem, std::uint64_t seed = 1) const {
    return GetParam().registry().find(GetParam().id)->make(problem, seed);
  }
  TestHost hostFor(const Problem& problem, std::uint64_t maxSteps = 20000) const {
    TestHost host(problem, maxSteps);
    EXPECT_TRUE(host.values.set(ParameterId::Slots, GetParam().slots));
    return host;
  }
  bool complete() const { return GetParam().registry().find(GetParam().id)->complete; }
};

TEST_P(PlannerConformance, SolvesTheWindowWithACertifiedPathFromStartToGoal) {
  const Problem problem = windowProblem();
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    TestHost host = hostFor(problem);
    ASSERT_TRUE(host.values.set(ParameterId::StepSamples, 2000));  // incomplete planners give up soon
    const auto planner = make(problem, seed);
    const bool solved = planner->solve(host);
    if (!complete() && !solved) {
      EXPECT_TRUE(planner->failure()) << "gave up without a word, seed " << seed;
      EXPECT_EQ(planner->path(), nullptr);
      continue;
    }
    ASSERT_TRUE(solved) << "seed " << seed;
    const Path* path = planner->path();
    ASSERT_NE(path, nullptr);
    EXPECT_EQ(path->points.front().q, problem.start);
    EXPECT_EQ(path->points.back().q, std::get<Pose>(problem.goal));
    EXPECT_EQ(path->certificate.status, CertificateStatus::Certified);
    EXPECT_GE(path->certificate.provedClearance, host.values[ParameterId::RequiredClearance]);
    const auto query = problem.world->makeQuery();
    EXPECT_EQ(certifyPath(*query, path->configurations(), host.values[ParameterId::RequiredClearance]).status,
              CertificateStatus::Certified);
  }
}

/// The start touches the wall beside the window. The object is thinner against that wall.
TEST_P(PlannerConformance, StartsWhereTheObjectFitsABody) {
  Problem problem = windowProblem();
  problem.start = Pose::translation({-0.3, -0.9, 0.0});
  const auto thinner = std::make_shared<const TriangleMesh>(makeBox({0.38, 0.38, 0.38}));
  problem.world = problem.world->withVariants({{thinner, {0}}});
  TestHost host = hostFor(problem);
  ASSERT_TRUE(host.values.set(ParameterId::StepSamples, 2000));
  const auto planner = make(problem);
  const bool solved = planner->solve(host);
  if (!complete() && !solved) return;
  ASSERT_TRUE(solved);
  const auto query = problem.world->makeQuery();
  EXPECT_EQ(certifyPath(*query, planner->path()->configurations(), host.values[ParameterId::RequiredClearance]).status,
            CertificateStatus::Certified);
}

TEST_P(PlannerConformance, CountsAreThoseOfTheRoadmap) {
  const Problem problem = windowProblem();
  TestHost host = hostFor(problem);
  const auto planner = make(problem);
  ASSERT_TRUE(planner->solve(host) || !complete());
  const PlannerCounts& counts = planner->counts();
  EXPECT_EQ(counts.nodes, planner->nodes().size());
  EXPECT_EQ(counts.edges, 2 * (planner->edges().size() - planner->droppedEdges().size()));
  EXPECT_EQ(counts.droppedEdges, planner->droppedEdges().size());
  EXPECT_GE(counts.steps, counts.randomConfigurations + counts.operatorConfigurations + counts.contactConfigurations);
  EXPECT_GT(counts.queries.collision + counts.queries.distance, 0U);
  if (growsOneTreePair(GetParam().id)) {
    // Without dropped edges the identity of the papers' tables holds.
    ASSERT_EQ(counts.droppedEdges, 0U);
    EXPECT_EQ(counts.edges, 2 * counts.nodes - 2);
  }
}

TEST_P(PlannerConformance, SameSeedGrowsTheSameRoadmapBitByBitHoweverOftenItIsInterrupted) {
  const Problem problem = windowProblem();
  const auto whole = make(problem, 3);
  TestHost host = hostFor(problem);
  host.sample = operatorAt(problem, Pose::translation({-0.4, 0.1, 0.05}));
  const bool solved = whole->solve(host);
  ASSERT_TRUE(solved || whole->failure());
  const auto pieces = make(problem, 3);
  do {
    host.stepsLeft = 1;
  } while (!pieces->solve(host) && !pieces->failure());
  EXPECT_EQ(pieces->path() != nullptr, solved);
  ASSERT_EQ(whole->nodes().size(), pieces->nodes().size());
  for (std::size_t i = 0; i < whole->nodes().size(); ++i) EXPECT_EQ(whole->nodes()[i].q, pieces->nodes()[i].q);
}

TEST_P(PlannerConformance, DifferentSeedsGrowDifferentRoadmaps) {
  if (GetParam().isDeterministic) GTEST_SKIP() << "draws nothing at random";
  // Planners that plan coarsely draw nothing where there is no way.
  const Problem problem = complete() ? closedProblem() : windowProblem();
  std::set<double> seen;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    TestHost host = hostFor(problem, 40);
    const auto planner = make(problem, seed);
    planner->solve(host);
    double sum = 0.0;
    for (const RoadmapNode& node : planner->nodes()) sum += node.q.position.x();
    seen.insert(sum);
  }
  EXPECT_EQ(seen.size(), 4U);
}

TEST_P(PlannerConformance, EveryNodeIsFreeAndEveryEdgeWasCheckedAtItsEnds) {
  const Problem problem = windowProblem();
  TestHost host = hostFor(problem, 300);
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
  TestHost host = hostFor(problem, 50);
  const auto planner = make(problem);
  EXPECT_FALSE(planner->solve(host));
  EXPECT_EQ(planner->path(), nullptr);
  EXPECT_LE(planner->counts().steps, 50U);
  if (growsOneTreePair(GetParam().id)) {
    EXPECT_EQ(planner->counts().steps, 50U);
  }
}

TEST_P(PlannerConformance, AStopIsSeenInsideAStep) {
  const Problem problem = windowProblem();
  TestHost host = hostFor(problem);
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
  TestHost host = hostFor(problem);
  const auto planner = make(problem);
  if (!planner->solve(host)) {
    ASSERT_FALSE(complete());
    EXPECT_TRUE(planner->failure());
    return;
  }
  const Vector3 end = planner->path()->points.back().q.position;
  EXPECT_GE(problem.world->obstaclesBox().exteriorDistance(end), problem.world->objectRadius() - 1e-9);
}

std::string entryName(const testing::TestParamInfo<PlannerUnderTest>& parameter) {
  std::string name = parameter.param.registryName + "_" + parameter.param.id;
  if (parameter.param.slots > 1) name += "_" + std::to_string(parameter.param.slots) + "_slots";
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Registries, PlannerConformance, testing::ValuesIn(plannersUnderTest()), entryName);

}  // namespace
}  // namespace glissade
