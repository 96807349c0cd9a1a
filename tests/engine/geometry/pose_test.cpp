#include "engine/geometry/pose.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/geometry/se3_metric.h"
#include "engine/geometry/straight_motion.h"
#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

TEST(Pose, ComposesLikeMatrices) {
  RandomStream stream(1, "pose");
  for (int i = 0; i < 200; ++i) {
    const Pose a = randomPose(stream, 3.0);
    const Pose b = randomPose(stream, 3.0);
    const Vector3 p(stream.normal(), stream.normal(), stream.normal());
    EXPECT_TRUE(((a * b) * p).isApprox(toIsometry(a) * (toIsometry(b) * p), 1e-12));
    EXPECT_TRUE((inverse(a) * (a * p)).isApprox(p, 1e-12));
  }
}

TEST(Pose, RollPitchYawIsUrdfsFixedAxisConvention) {
  const Quaternion q = fromRollPitchYaw(0.3, -0.5, 1.1);
  const Eigen::Matrix3d expected =
      (Eigen::AngleAxisd(1.1, Vector3::UnitZ()) * Eigen::AngleAxisd(-0.5, Vector3::UnitY()) *
       Eigen::AngleAxisd(0.3, Vector3::UnitX()))
          .toRotationMatrix();
  EXPECT_TRUE(q.toRotationMatrix().isApprox(expected, 1e-12));
}

TEST(Pose, RollPitchYawComeBackFromEveryOrientation) {
  RandomStream stream(5, "roll pitch yaw");
  const auto expectBack = [](const Quaternion& q) {
    const Vector3 angles = rollPitchYawOf(q);
    EXPECT_LE(std::abs(angles.y()), std::acos(0.0) + 1e-12);
    EXPECT_LT(angleBetween(fromRollPitchYaw(angles.x(), angles.y(), angles.z()), q), 1e-6);
  };
  for (int i = 0; i < 200; ++i) expectBack(randomPose(stream, 1.0).orientation);
  for (const double pitch : {-std::acos(0.0), std::acos(0.0)}) expectBack(fromRollPitchYaw(0.4, pitch, -1.3));
  EXPECT_LT((rollPitchYawOf(fromRollPitchYaw(0.3, -0.5, 1.1)) - Vector3(0.3, -0.5, 1.1)).norm(), 1e-12);
}

TEST(Pose, InterpolationHitsItsEndsExactlyAndTurnsTheShortWay) {
  RandomStream stream(2, "interpolate");
  for (int i = 0; i < 200; ++i) {
    const Pose a = randomPose(stream, 3.0);
    const Pose b = randomPose(stream, 3.0);
    EXPECT_EQ(interpolate(a, b, 0.0), a);
    EXPECT_EQ(interpolate(a, b, 1.0), b);
    const Pose middle = interpolate(a, b, 0.25);
    const double whole = angleBetween(a.orientation, b.orientation);
    EXPECT_NEAR(angleBetween(a.orientation, middle.orientation), 0.25 * whole, 1e-9);
    EXPECT_LE(whole, 3.14159265358979 + 1e-9);
  }
}

TEST(StraightMotion, IsInterpolationBitByBit) {
  RandomStream stream(3, "straight motion");
  for (int i = 0; i < 500; ++i) {
    const Pose a = randomPose(stream, 3.0);
    Pose b = randomPose(stream, 3.0);
    if (i % 5 == 0) b.orientation = a.orientation;
    if (i % 5 == 1) b.orientation = (a.orientation * fromRotationVector({0.0, 1e-8 * i, 0.0})).normalized();
    if (i % 2 == 0) b.orientation.coeffs() *= -1.0;
    const StraightMotion motion(a, b);
    for (const double t : {0.0, 1.0, 0.5, 0.25, 0x1p-30, stream.uniform()})
      EXPECT_EQ(motion.at(t), interpolate(a, b, t));
  }
}

TEST(Pose, InvalidOnesAreSeen) {
  Pose pose;
  EXPECT_TRUE(isValid(pose));
  pose.position.x() = std::nan("");
  EXPECT_FALSE(isValid(pose));
  pose = Pose::identity();
  pose.orientation.coeffs() *= 1.1;
  EXPECT_FALSE(isValid(pose));
}

TEST(Se3Metric, IsSymmetricIgnoresTheQuaternionsSignAndObeysTheTriangleInequality) {
  const Se3Metric metric(1.536);
  RandomStream stream(3, "metric");
  for (int i = 0; i < 500; ++i) {
    const Pose a = randomPose(stream, 3.0);
    Pose b = randomPose(stream, 3.0);
    const Pose c = randomPose(stream, 3.0);
    EXPECT_DOUBLE_EQ(metric.distance(a, b), metric.distance(b, a));
    EXPECT_LE(metric.distance(a, c), metric.distance(a, b) + metric.distance(b, c) + 1e-9);
    const double before = metric.distance(a, b);
    b.orientation.coeffs() *= -1.0;
    EXPECT_DOUBLE_EQ(metric.distance(a, b), before);
  }
  EXPECT_EQ(metric.distance(Pose::identity(), Pose::identity()), 0.0);
}

}  // namespace
}  // namespace glissade
