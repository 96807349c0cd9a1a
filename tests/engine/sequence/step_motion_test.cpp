#include "engine/sequence/step_motion.h"

#include <gtest/gtest.h>

#include "engine/base/random_stream.h"

namespace glissade {
namespace {

PathPoint at(const Vector3& p, double yaw = 0.0) { return {{p, fromRollPitchYaw(0.0, 0.0, yaw)}, Author::Computer}; }

TEST(StepMotion, EdgesInOneDirectionAreOneLeg) {
  const auto legs = legsOf({at({0, 0, 0}), at({0, 0, 0.1}), at({0, 0, 0.3}), at({0.2, 0, 0.3})});
  ASSERT_EQ(legs.size(), 2U);
  EXPECT_NEAR(legs[0].length, 0.3, 1e-12);
  EXPECT_LT((legs[0].direction - Vector3::UnitZ()).norm(), 1e-12);
  EXPECT_NEAR(legs[1].length, 0.2, 1e-12);
  EXPECT_EQ(legs[1].turn, 0.0);
}

TEST(StepMotion, ATurnHasAnAxisAndAnAngle) {
  const auto legs = legsOf({at({0, 0, 0}), at({0, 0, 0}, 0.5), at({0, 0, 0}, 1.2)});
  ASSERT_EQ(legs.size(), 1U);
  EXPECT_NEAR(legs[0].turn, 1.2, 1e-9);
  EXPECT_EQ(legs[0].length, 0.0);
  EXPECT_LT((legs[0].axis - Vector3::UnitZ()).norm(), 1e-9);
}

TEST(StepMotion, WhatDoesNotMoveHasNoLegsAndLeavesUpwards) {
  EXPECT_TRUE(legsOf({at({1, 2, 3}), at({1, 2, 3})}).empty());
  EXPECT_EQ(exitDirection({at({1, 2, 3})}), Vector3(Vector3::UnitZ()));
}

TEST(StepMotion, TheReverseOfThePathHasTheReversedLegs) {
  RandomStream random(1, "legs");
  for (int round = 0; round < 50; ++round) {
    std::vector<PathPoint> path;
    for (int i = 0; i < 4; ++i) {
      path.push_back(at({random.uniform(), random.uniform(), random.uniform()}, random.uniform(-1.0, 1.0)));
    }
    const auto back = reversed(legsOf(path));
    std::reverse(path.begin(), path.end());
    const auto legs = legsOf(path);
    ASSERT_EQ(legs.size(), back.size());
    for (std::size_t i = 0; i < legs.size(); ++i) {
      EXPECT_LT((legs[i].direction - back[i].direction).norm(), 1e-9);
      EXPECT_LT((legs[i].axis - back[i].axis).norm(), 1e-6);
      EXPECT_NEAR(legs[i].turn, back[i].turn, 1e-9);
    }
  }
}

}  // namespace
}  // namespace glissade
