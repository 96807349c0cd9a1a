#include "engine/planning/nearest_neighbours.h"

#include <gtest/gtest.h>

#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

TEST(NearestNeighbours, AgreesWithThePlainMinimumAlsoForNearlyEqualOrientations) {
  const Se3Metric metric(1.536);
  RandomStream stream(11, "neighbours");
  NearestNeighbours neighbours(metric);
  std::vector<Pose> poses;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    Pose q = randomPose(stream, 2.0);
    if (i % 3 == 0 && i > 0) {  // a near twin of an earlier one, half of them with the other sign
      q = poses[i / 2];
      q.position += 1e-6 * Vector3(stream.normal(), stream.normal(), stream.normal());
      if (i % 2 == 0) q.orientation.coeffs() *= -1.0;
    }
    poses.push_back(q);
    neighbours.add(i, q);
  }
  for (int trial = 0; trial < 500; ++trial) {
    const Pose q = trial % 2 == 0 ? randomPose(stream, 2.0) : poses[static_cast<std::size_t>(trial)];
    double best = std::numeric_limits<double>::infinity();
    for (const Pose& pose : poses) best = std::min(best, metric.distance(pose, q));
    const auto found = neighbours.nearest(q);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->distance, best);
    EXPECT_EQ(metric.distance(poses[found->index], q), best);
  }
}

TEST(NearestNeighbours, FirstAmongEqualsAndNothingWhenEmpty) {
  NearestNeighbours neighbours(Se3Metric(1.0));
  EXPECT_FALSE(neighbours.nearest(Pose::identity()));
  neighbours.add(7, Pose::identity());
  neighbours.add(3, Pose::identity());
  EXPECT_EQ(neighbours.nearest(Pose::translation({1, 0, 0}))->index, 7U);
}

}  // namespace
}  // namespace glissade
