#include "engine/planning/automatic/automatic_planner.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/engine/support/test_host.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

TEST(AutomaticPlanner, NamesTheMemberThatFoundThePath) {
  const Problem problem = windowProblem();
  TestHost host(problem);
  AutomaticPlanner planner(problem, 1);
  EXPECT_EQ(planner.member(), "");
  ASSERT_TRUE(planner.solve(host));
  std::set<std::string> names;
  for (const Member& member : makeMembers(problem)) names.insert(member.name);
  EXPECT_EQ(names.count(planner.member()), 1U);
}

TEST(AutomaticPlanner, SameSeedGivesTheSamePathAndCounts) {
  const Problem problem = windowProblem();
  const auto run = [&] {
    TestHost host(problem);
    AutomaticPlanner planner(problem, 5);
    EXPECT_TRUE(planner.solve(host));
    return std::make_tuple(planner.member(), planner.path()->configurations(), planner.counts().queries.collision);
  };
  EXPECT_EQ(run(), run());
}

TEST(AutomaticPlanner, ListsWhatItsMembersHaveGrownOnceTheRunEnds) {
  const Problem problem = closedProblem();
  TestHost host(problem, 300);
  AutomaticPlanner planner(problem, 2);
  EXPECT_FALSE(planner.solve(host));
  planner.completeRoadmap();
  EXPECT_EQ(planner.counts().nodes, planner.nodes().size());
  EXPECT_EQ(planner.counts().edges, 2 * (planner.edges().size() - planner.droppedEdges().size()));
  for (const RoadmapEdge& edge : planner.edges()) {
    EXPECT_LT(std::max(edge.from, edge.to), planner.nodes().size());
  }
  EXPECT_GT(planner.edges().size(), 10U);
}

TEST(AutomaticPlanner, GivesUpWhereNothingIsOutside) {
  Problem problem = windowProblem();
  problem.goal = GoalOut{};
  problem.start = Pose::translation({-0.35, 0.0, 0.0});
  problem.bounds = Box3(Vector3(-0.4, -0.1, -0.1), Vector3(-0.3, 0.1, 0.1));
  TestHost host(problem);
  AutomaticPlanner planner(problem, 1);
  EXPECT_FALSE(planner.solve(host));
  ASSERT_TRUE(planner.failure());
  EXPECT_EQ(planner.failure()->kind, ErrorKind::NoPath);
}

}  // namespace
}  // namespace glissade
