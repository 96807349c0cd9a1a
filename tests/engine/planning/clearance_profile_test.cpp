#include "engine/planning/clearance_profile.h"

#include <gtest/gtest.h>

#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

std::vector<Pose> wayThroughTheWindow() {
  return {Pose::translation({-1.5, 0.0, 0.0}),
          Pose::translation({-0.5, 0.1, 0.05}),
          {Vector3(0.5, -0.1, 0.0), Quaternion(Eigen::AngleAxisd(0.7, Vector3::UnitX()))},
          Pose::translation({1.5, 0.5, 0.5})};
}

TEST(ClearanceProfile, EveryDistanceIsThatOfItsPlace) {
  const Problem problem = windowProblem();
  const auto query = problem.world->makeQuery();
  const auto reference = problem.world->withBackend(CollisionBackend::Fcl)->makeQuery();
  const std::vector<Pose> way = wayThroughTheWindow();
  const Se3Metric metric = problem.metric();
  const ClearanceProfile profile = clearanceProfile(*query, way, metric, 1000);
  ASSERT_GE(profile.samples.size(), 1000U);
  double length = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) length += metric.distance(way[i - 1], way[i]);
  double before = 0.0;
  std::size_t sample = 0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double edge = metric.distance(way[i - 1], way[i]);
    for (; sample < profile.samples.size(); ++sample) {
      const double at = (profile.samples[sample].share * length - before) / edge;
      if (at > 1.0 + 1e-12) break;
      const Pose q = interpolate(way[i - 1], way[i], std::min(at, 1.0));
      EXPECT_NEAR(profile.samples[sample].nearest.distance, reference->nearestObstacle(q).distance, 1e-9);
    }
    before += edge;
  }
  EXPECT_EQ(sample, profile.samples.size());
}

TEST(ClearanceProfile, TheTightestPlaceIsTheSmallestDistance) {
  const Problem problem = windowProblem();
  const auto query = problem.world->makeQuery();
  const ClearanceProfile profile = clearanceProfile(*query, wayThroughTheWindow(), problem.metric(), 200);
  const auto tightest = profile.tightest();
  ASSERT_TRUE(tightest);
  for (const ClearanceSample& sample : profile.samples) {
    EXPECT_GE(sample.nearest.distance, profile.samples[*tightest].nearest.distance);
  }
  EXPECT_LT(profile.samples[*tightest].nearest.distance, 0.31);
  EXPECT_FALSE(ClearanceProfile().tightest());
}

TEST(ClearanceProfile, SharesGrowFromZeroToOne) {
  const Problem problem = windowProblem();
  const auto query = problem.world->makeQuery();
  const ClearanceProfile profile = clearanceProfile(*query, wayThroughTheWindow(), problem.metric(), 50);
  EXPECT_EQ(profile.samples.front().share, 0.0);
  EXPECT_DOUBLE_EQ(profile.samples.back().share, 1.0);
  for (std::size_t i = 1; i < profile.samples.size(); ++i) {
    EXPECT_GT(profile.samples[i].share, profile.samples[i - 1].share);
  }
}

TEST(ClearanceProfile, AStopLeavesAnIncompleteProfile) {
  const Problem problem = windowProblem();
  const auto query = problem.world->makeQuery();
  StopSource stop;
  stop.requestStop();
  const ClearanceProfile profile =
      clearanceProfile(*query, wayThroughTheWindow(), problem.metric(), 50, WorkWatch(stop.token()));
  EXPECT_FALSE(profile.complete);
  EXPECT_TRUE(profile.samples.empty());
}

TEST(ClearanceProfile, AWayWithoutLengthHasItsConfigurationsOnly) {
  const Problem problem = windowProblem();
  const auto query = problem.world->makeQuery();
  EXPECT_TRUE(clearanceProfile(*query, {}, problem.metric(), 50).samples.empty());
  EXPECT_EQ(clearanceProfile(*query, {problem.start, problem.start}, problem.metric(), 50).samples.size(), 2U);
}

}  // namespace
}  // namespace glissade
