#include "engine/operator/operator_input.h"

#include <gtest/gtest.h>

#include "tests/engine/operator/operator_support.h"
#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

TEST(Integrate, AtRestNothingChangesBitByBit) {
  RandomStream stream(1, "rest");
  for (int i = 0; i < 50; ++i) {
    const Pose q = randomPose(stream, 3.0);
    EXPECT_EQ(integrate(q, Twist(), kRoom, 0.1), q);
    EXPECT_EQ(integrate(q, {Vector3::Ones(), Vector3::Ones()}, kRoom, 0.0), q);
  }
}

TEST(Integrate, TranslatesAndTurnsAboutTheReferencePointInTheWorldFrame) {
  const Pose q = integrate(Pose::translation({1, 0, 0}), {{0, 2, 0}, {0, 0, std::acos(0.0)}}, kRoom, 0.5);
  EXPECT_TRUE(q.position.isApprox(Vector3(1, 1, 0), 1e-12));
  EXPECT_NEAR(angleBetween(Quaternion::Identity(), q.orientation), std::acos(0.0) / 2, 1e-12);
  EXPECT_GT((q.orientation * Vector3::UnitX()).y(), 0.0);
}

TEST(Integrate, OnlyTheBoundsStopTheDevice) {
  const Pose q = integrate(Pose::identity(), {{100, 0, -100}, Vector3::Zero()}, kRoom, 1.0);
  EXPECT_EQ(q.position, Vector3(5, 0, -5));
}

TEST(ToTwist, TurnsTheViewsAxesIntoTheWorldsAndClampsTheDeflection) {
  OperatorFrame frame;
  frame.R_WV = Quaternion(Eigen::AngleAxisd(std::acos(0.0), Vector3::UnitZ()));
  frame.speed = {2.0, 3.0};
  const Twist twist = toTwist({{5.0, 0, 0}, {0, 0.5, 0}}, frame);
  EXPECT_TRUE(twist.linear_W.isApprox(Vector3(0, 2, 0), 1e-12));
  EXPECT_TRUE(twist.angular_W.isApprox(Vector3(-1.5, 0, 0), 1e-12));
}

}  // namespace
}  // namespace glissade
