#include "engine/planning/contact/contact_sampler.h"

#include <gtest/gtest.h>

#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

TEST(ContactSampler, KeepsTheGapToThePlaneTheOrientationAndTheDisc) {
  RandomStream stream(3, "planes");
  for (int trial = 0; trial < 100; ++trial) {
    OperatorSample operatorSample;
    operatorSample.q_device = randomPose(stream, 2.0);
    operatorSample.nearest.p_WPo = randomPose(stream, 2.0).position;
    operatorSample.nearest.p_WPn = randomPose(stream, 2.0).position;
    operatorSample.nearest.distance = (operatorSample.nearest.p_WPn - operatorSample.nearest.p_WPo).norm();
    const Vector3 n = operatorSample.nearest.normal_W();
    ContactSampler sampler(trial);
    sampler.enter(operatorSample, 1e-3, 2.0);
    for (int i = 0; i < 50; ++i) {
      const Pose q = sampler.sample();
      const Vector3 moved = q.position - operatorSample.q_device.position;
      EXPECT_NEAR(n.dot(moved), 1e-3 - operatorSample.nearest.distance, 1e-12);
      EXPECT_LE((moved - n.dot(moved) * n).norm(), 2.0 + 1e-12);
      EXPECT_EQ(q.orientation.coeffs(), operatorSample.q_device.orientation.coeffs());
    }
  }
}

TEST(ContactSampler, OnARealTiltedPlaneSamplesTouchWithoutPenetrating) {
  Pose tilted;
  tilted.orientation = fromRollPitchYaw(0.5, -0.3, 0.2);
  const auto world = CollisionWorld::build({boxBody("plane", {20.0, 20.0, 0.1}, tilted)}, makeL());
  const auto query = world->makeQuery();
  OperatorSample operatorSample;
  operatorSample.q_device.position = tilted * Vector3(0.0, 0.0, 1.2);
  operatorSample.q_device.orientation = fromRollPitchYaw(0.4, 0.1, 1.0);
  operatorSample.nearest = query->nearestObstacle(operatorSample.q_device);
  ASSERT_GT(operatorSample.nearest.distance, 0.0);
  ContactSampler sampler(1);
  sampler.enter(operatorSample, 1.5e-3, 2.0);
  for (int i = 0; i < 200; ++i) {
    EXPECT_NEAR(query->nearestObstacle(sampler.sample()).distance, 1.5e-3, 1e-9);
  }
}

}  // namespace
}  // namespace glissade
