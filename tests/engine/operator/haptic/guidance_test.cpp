#include "engine/operator/guidance.h"

#include <gtest/gtest.h>

#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

NearestObstacle floorBelow(const Pose& q, double gap) {
  NearestObstacle nearest;
  nearest.body = 0;
  nearest.distance = gap;
  nearest.p_WPn = q.position + Vector3(0.5, 0.0, 0.0);
  nearest.p_WPo = nearest.p_WPn - Vector3(0.0, 0.0, gap);
  return nearest;
}

TEST(Repulsion, PushesAwaySmoothlyAndNoHarderThanItsStrength) {
  const Guidance guidance{0.7, 0.0, 0.2, std::nullopt};
  double last = 0.0;
  for (double gap = 0.25; gap > 1e-3; gap -= 1e-3) {
    const Wrench wrench = repulsion(guidance, Pose(), floorBelow(Pose(), gap), 1.0);
    const double strength = wrench.force_W.z();
    EXPECT_EQ(wrench.force_W.norm(), strength);
    EXPECT_GE(strength, last);
    EXPECT_LT(strength - last, 0.01);
    EXPECT_LT(strength, 0.7);
    EXPECT_EQ(strength > 0.0, gap < 0.2);
    EXPECT_NEAR(wrench.torque_W.y(), -0.5 * strength, 1e-12);
    last = strength;
  }
  EXPECT_GT(last, 0.65);
}

TEST(Repulsion, IsNothingWithoutADirection) {
  const Guidance guidance{1.0, 0.0, 0.2, std::nullopt};
  EXPECT_TRUE(repulsion(guidance, Pose(), NearestObstacle(), 1.0).isZero());
  EXPECT_TRUE(repulsion(guidance, Pose(), floorBelow(Pose(), 0.0), 1.0).isZero());
}

TEST(Attraction, DrawsToTheTargetAndIsCapped) {
  RandomStream stream(1, "poses");
  for (int i = 0; i < 1000; ++i) {
    const Pose target = randomPose(stream, 3.0);
    const Pose q = randomPose(stream, 3.0);
    const Wrench wrench = attraction({0.0, 0.4, 0.2, target}, q, 0.7);
    EXPECT_LE(wrench.force_W.norm(), 0.4);
    EXPECT_LE(wrench.torque_W.norm(), 0.4);
    EXPECT_GT(wrench.force_W.dot(target.position - q.position), 0.0);
    EXPECT_TRUE(attraction({0.0, 0.4, 0.2, target}, target, 0.7).isZero());
  }
  EXPECT_TRUE(attraction({0.0, 0.4, 0.2, std::nullopt}, Pose(), 0.7).isZero());
}

TEST(AheadOnWay, RunsAheadOfTheNearestPointAndStopsAtTheEnd) {
  const std::vector<Pose> way{Pose::translation({0, 0, 0}), Pose::translation({1, 0, 0}), Pose::translation({1, 1, 0})};
  const Se3Metric metric(1.0);
  const auto at = [&](const Vector3& p, double ahead) { return aheadOnWay(way, Pose::translation(p), metric, ahead); };
  EXPECT_TRUE(at({0.25, 0.1, 0.0}, 0.5)->position.isApprox(Vector3(0.75, 0.0, 0.0)));
  EXPECT_TRUE(at({0.75, -0.1, 0.0}, 0.5)->position.isApprox(Vector3(1.0, 0.25, 0.0)));
  EXPECT_TRUE(at({2.0, 0.8, 0.0}, 0.5)->position.isApprox(Vector3(1.0, 1.0, 0.0)));
  EXPECT_FALSE(aheadOnWay({}, Pose(), metric, 0.5));
  EXPECT_EQ(*aheadOnWay({way[1]}, Pose(), metric, 0.5), way[1]);
}

}  // namespace
}  // namespace glissade
