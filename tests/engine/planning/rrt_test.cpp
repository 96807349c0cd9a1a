#include "engine/planning/rrt.h"

#include <gtest/gtest.h>

#include "tests/engine/support/test_host.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

TEST(Rrt, GrowsOneTreeFromTheStart) {
  const Problem problem = windowProblem();
  TestHost host(problem);
  Rrt rrt(problem, 1);
  ASSERT_TRUE(rrt.solve(host));
  EXPECT_EQ(rrt.nodes().front().q, problem.start);
  EXPECT_EQ(rrt.edges().size() + 1, rrt.nodes().size());
  for (const RoadmapNode& node : rrt.nodes()) EXPECT_EQ(node.side, TreeSide::Start);
  EXPECT_EQ(rrt.counts().randomConfigurations, rrt.counts().steps);
}

TEST(Rrt, AsStrategyGItGivesUpAtItsLimitAndAsALocalPlannerNever) {
  const Problem problem = closedProblem();
  for (const auto limit : {Rrt::Limit::GlobalSamples, Rrt::Limit::None}) {
    TestHost host(problem, 500);
    ASSERT_TRUE(host.values.set(ParameterId::GlobalSamples, 200));
    Rrt rrt(problem, 1, limit);
    EXPECT_FALSE(rrt.solve(host));
    const bool limited = limit == Rrt::Limit::GlobalSamples;
    EXPECT_EQ(rrt.counts().randomConfigurations, limited ? 200U : 500U);
    ASSERT_EQ(rrt.failure().has_value(), limited);
    if (limited) {
      EXPECT_EQ(rrt.failure()->kind, ErrorKind::LimitReached);
      EXPECT_FALSE(rrt.solve(host)) << "no path can come after a failure";
      EXPECT_EQ(rrt.counts().randomConfigurations, 200U);
    }
  }
}

TEST(Rrt, DrawsFromTheRegionWhereThereIsOne) {
  Problem problem = closedProblem();
  CellGrid grid;
  grid.frame = CellFrame::covering(problem.bounds);
  grid.level = 2;  // cells of 1 m
  grid.counts = {4, 4, 4};
  const std::size_t cell = *grid.find(problem.start.position);
  problem.region = std::make_shared<const SamplingRegion>(grid, std::vector<std::size_t>{cell});
  TestHost host(problem, 300);
  Rrt rrt(problem, 3);
  rrt.solve(host);
  int inside = 0;
  for (const RoadmapNode& node : rrt.nodes()) inside += problem.region->contains(node.q.position) ? 1 : 0;
  // One draw in twenty is the goal, and leads out of the region.
  EXPECT_GT(inside, static_cast<int>(0.85 * static_cast<double>(rrt.nodes().size())));
  EXPECT_GT(rrt.nodes().size(), 100U);
}

}  // namespace
}  // namespace glissade
