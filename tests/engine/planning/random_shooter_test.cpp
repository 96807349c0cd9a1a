#include "engine/planning/random_shooter.h"

#include <gtest/gtest.h>

#include <map>

namespace glissade {
namespace {

Problem inBounds(const Box3& bounds) {
  Problem problem;
  problem.bounds = bounds;
  return problem;
}

TEST(RandomShooter, StaysInTheBoundsAndFillsThem) {
  const Box3 bounds(Vector3(-1, 0, 5), Vector3(3, 0.5, 6));
  RandomShooter shooter(inBounds(bounds), 1);
  Box3 seen;
  Eigen::Vector4d meanAbs = Eigen::Vector4d::Zero();
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) {
    const Pose q = shooter.shoot();
    ASSERT_TRUE(bounds.contains(q.position));
    ASSERT_NEAR(q.orientation.norm(), 1.0, 1e-12);
    seen.extend(q.position);
    meanAbs += q.orientation.coeffs().cwiseAbs();
  }
  EXPECT_GT(seen.volume(), 0.99 * bounds.volume());
  // Uniform on the sphere S3: every coordinate has the mean absolute value 4 / (3 pi).
  meanAbs /= kCount;
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(meanAbs[i], 0.42441, 0.01);
}

TEST(RandomShooter, SameSeedSameShots) {
  const Box3 bounds(Vector3::Zero(), Vector3::Ones());
  RandomShooter a(inBounds(bounds), 5);
  RandomShooter b(inBounds(bounds), 5);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(a.shoot(), b.shoot());
}

TEST(RandomShooter, StaysInTheRegionAndReachesAllOfIt) {
  CellGrid grid;
  grid.frame = {Vector3(-1, -1, -1), 2.0};
  grid.level = 2;
  grid.counts = {4, 4, 4};
  Problem problem = inBounds(Box3(Vector3::Constant(-1), Vector3::Ones()));
  const std::vector<std::size_t> cells{0, 21, 63};
  problem.region = std::make_shared<const SamplingRegion>(grid, cells);
  RandomShooter shooter(problem, 2);
  std::map<std::size_t, int> hits;
  constexpr int kCount = 6000;
  for (int i = 0; i < kCount; ++i) {
    const Pose q = shooter.shoot();
    ASSERT_TRUE(problem.region->contains(q.position));
    ++hits[*grid.find(q.position)];
  }
  ASSERT_EQ(hits.size(), cells.size());
  for (const std::size_t cell : cells) EXPECT_NEAR(hits[cell], kCount / 3.0, 150);  // within four standard deviations
}

TEST(RandomShooter, StaysInTheBoundsWhereCellsOfTheRegionReachBeyondThem) {
  CellGrid grid;
  grid.frame = {Vector3(-1, -1, -1), 2.0};
  grid.level = 2;
  grid.counts = {4, 4, 4};
  Problem problem = inBounds(Box3(Vector3::Constant(-1), Vector3(1.0, 1.0, 0.6)));
  problem.region = std::make_shared<const SamplingRegion>(grid, std::vector<std::size_t>{62, 63});
  RandomShooter shooter(problem, 2);
  Box3 seen;
  for (int i = 0; i < 1000; ++i) {
    const Pose q = shooter.shoot();
    ASSERT_TRUE(problem.bounds.contains(q.position)) << q.position.transpose();
    seen.extend(q.position);
  }
  EXPECT_GT(seen.max().z(), 0.55);
  EXPECT_LT(seen.min().z(), 0.05);
}

}  // namespace
}  // namespace glissade
