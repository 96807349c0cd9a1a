#include "engine/planning/automatic/sliding_extension.h"

#include <gtest/gtest.h>

#include "engine/collision/motion_certificate.h"
#include "engine/planning/automatic/rrt_connect.h"
#include "tests/engine/support/test_host.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

constexpr double kStep = 0.01;

/// The object is in front of a closed wall, so near that the motion meets it.
class Sliding : public testing::Test {
 protected:
  Problem problem = windowProblem();
  std::unique_ptr<CollisionQuery> query = problem.world->makeQuery();
  Se3Metric metric = problem.metric();
  Pose from = Pose::translation({-0.5, 1.2, 0.0});
  Pose target = Pose::translation({-0.2, 1.4, 0.1});
  SlidingExtension sliding{*query, problem.bounds, metric, 0.4};
};

TEST_F(Sliding, GoesOnAlongTheWall) {
  ASSERT_FALSE(query->collides(from));
  ASSERT_TRUE(query->collides(target));
  const auto end = sliding.slide(0, from, target, kStep, {});
  ASSERT_TRUE(end);
  EXPECT_GE(freeFraction(*query, from, *end, kStep), 1.0);
  EXPECT_GT(end->position.x(), from.position.x() + 0.1) << "up to the wall";
  EXPECT_NEAR(end->position.y(), target.position.y(), 0.02) << "and along it";
  EXPECT_GT(query->nearestObstacle(*end).distance, 0.0);
}

TEST_F(Sliding, AChildBeginsWithThePlanesOfItsParent) {
  const auto end = sliding.slide(0, from, target, kStep, {});
  ASSERT_TRUE(end);
  sliding.keep(0, 1);
  const Pose next{target.position + Vector3(0.1, 0.1, 0.0), target.orientation};
  const std::uint64_t before = query->counts().distance;
  constexpr double kOnlyTheEnd = 1.0;  // no distances at the samples before the end
  ASSERT_TRUE(sliding.slide(1, *end, next, kOnlyTheEnd, {}));
  EXPECT_EQ(query->counts().distance, before);
}

TEST_F(Sliding, DoesNotGoOnStraightAgainstTheWall) {
  const Pose touching = Pose::translation({-0.302, 1.2, 0.0});
  ASSERT_FALSE(query->collides(touching));
  EXPECT_FALSE(sliding.slide(0, touching, Pose::translation({-0.1, 1.2, 0.0}), kStep, {}));
}

TEST_F(Sliding, StaysInTheWorkspace) {
  const Vector3 beyond(-0.2, problem.bounds.max().y() + 0.1, 0.0);
  const Pose start = Pose::translation({-0.5, problem.bounds.max().y() - 0.01, 0.0});
  const auto end = sliding.slide(0, start, {beyond, start.orientation}, kStep, {});
  EXPECT_TRUE(!end || problem.bounds.contains(end->position));
}

TEST(SlidingTrees, FindAWindowWithFewerDrawsThanTreesThatStop) {
  Problem problem = windowProblem();
  problem.world = CollisionWorld::build(problem.world->obstacles(),
                                        std::make_shared<const TriangleMesh>(makeBox({0.85, 0.85, 0.85})));
  problem.start = Pose::translation({-1.2, 0.6, 0.5});
  problem.goal = Pose::translation({1.5, 0.0, 0.0});
  const auto draws = [&](bool slides, std::uint64_t seed) {
    RrtConnect::Options options;
    options.range = searchRange(problem, 0.03);
    options.slides = slides;
    RrtConnect planner(problem, seed, options, std::make_unique<UniformSampler>(problem, seed));
    TestHost host(problem);
    const bool solved = planner.solve(host);
    EXPECT_TRUE(solved || !slides);
    if (solved) {
      EXPECT_EQ(planner.path()->certificate.status, CertificateStatus::Certified);
    }
    return planner.counts().randomConfigurations;
  };
  std::uint64_t sliding = 0;
  std::uint64_t stopping = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    sliding += draws(true, seed);
    stopping += draws(false, seed);
    EXPECT_EQ(draws(true, seed), draws(true, seed)) << "one seed, one search";
  }
  EXPECT_LT(2 * sliding, stopping);
}

}  // namespace
}  // namespace glissade
