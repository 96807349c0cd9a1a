#include "engine/product/alignment.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

using Kind = MeasureFeature::Kind;

MeasureFeature face(const Pose& X_WF) {
  MeasureFeature feature;
  feature.kind = Kind::Face;
  feature.picked = X_WF.position;
  feature.direction = X_WF.orientation * Vector3::UnitZ();
  return feature;
}

MeasureFeature cylinder(const Pose& X_WF, double radius) {
  MeasureFeature feature = face(X_WF);
  feature.kind = Kind::Cylinder;
  feature.axisPoint = feature.picked;
  feature.picked = X_WF * Vector3(radius, 0.0, 0.0);
  feature.radius = radius;
  return feature;
}

double distanceToAxis(const Vector3& p, const MeasureFeature& axis) {
  return (p - axis.axisPoint).cross(axis.direction).norm();
}

/// Any poses, and poses whose directions are nearly equal or nearly opposite, where digits are lost easily.
std::vector<std::pair<Pose, Pose>> pairsOfPoses() {
  RandomStream random(7, "alignment");
  std::vector<std::pair<Pose, Pose>> pairs;
  for (int i = 0; i < 200; ++i) pairs.emplace_back(randomPose(random, 2.0), randomPose(random, 2.0));
  for (const double off : {0.0, 1e-12, 1e-9, 1e-6, 1e-3}) {
    for (const double turn : {0.0, std::numbers::pi}) {
      const Pose a = randomPose(random, 2.0);
      const Quaternion by(Eigen::AngleAxisd(turn + off, a.orientation * Vector3::UnitX()));
      pairs.emplace_back(a, Pose{randomPose(random, 2.0).position, by * a.orientation});
    }
  }
  return pairs;
}

TEST(Alignment, AxesAreCollinearAfterItWhicheverWayTheyLook) {
  for (const auto& [from, to] : pairsOfPoses()) {
    const MeasureFeature moving = cylinder(from, 0.01);
    const MeasureFeature fixed = cylinder(to, 0.02);
    ASSERT_TRUE(canAlign(moving, fixed));
    for (const bool flipped : {false, true}) {
      const MeasureFeature moved = placed(moving, alignment(moving, fixed, flipped));
      EXPECT_LT(moved.direction.cross(fixed.direction).norm(), 1e-9);
      EXPECT_LT(distanceToAxis(moved.axisPoint, fixed), 1e-9);
      EXPECT_LT(distanceToAxis(moved.axisPoint + moved.direction, fixed), 1e-9);
      const bool sameSide = moved.direction.dot(fixed.direction) > 0.0;
      const bool nearerSide = moving.direction.dot(fixed.direction) >= 0.0;
      EXPECT_EQ(sameSide, nearerSide != flipped);
    }
  }
}

TEST(Alignment, FacesAreCoplanarAfterItAndLookAtEachOther) {
  for (const auto& [from, to] : pairsOfPoses()) {
    const MeasureFeature moving = face(from);
    const MeasureFeature fixed = face(to);
    for (const bool flipped : {false, true}) {
      const Pose motion = alignment(moving, fixed, flipped);
      const MeasureFeature moved = placed(moving, motion);
      EXPECT_NEAR(moved.direction.dot(fixed.direction), flipped ? 1.0 : -1.0, 1e-12);
      for (const Vector3& p : {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0)}) {
        EXPECT_NEAR(fixed.direction.dot(motion * (from * p) - fixed.picked), 0.0, 1e-9);
      }
    }
  }
}

TEST(Alignment, IsTheLeastMotion) {
  for (const auto& [from, to] : pairsOfPoses()) {
    const MeasureFeature moving = cylinder(from, 0.01);
    const MeasureFeature fixed = cylinder(to, 0.02);
    const Pose motion = alignment(moving, fixed, false);
    const double angle = angleBetween(motion.orientation, Quaternion::Identity());
    EXPECT_NEAR(angle, std::acos(std::min(1.0, std::abs(moving.direction.dot(fixed.direction)))), 1e-6);
    const Vector3 went = motion * moving.axisPoint - moving.axisPoint;
    EXPECT_NEAR(went.norm(), distanceToAxis(moving.axisPoint, fixed), 1e-9);
    const MeasureFeature plane = face(from);
    const MeasureFeature other = face(to);
    const Vector3 met = alignment(plane, other, false) * plane.picked - plane.picked;
    EXPECT_NEAR(met.norm(), std::abs(other.direction.dot(other.picked - plane.picked)), 1e-9);
  }
}

/// What lies right already is not moved at all, apart from the last digits.
TEST(Alignment, LeavesWhatIsAligned) {
  RandomStream random(11, "aligned");
  for (int i = 0; i < 50; ++i) {
    const Pose from = randomPose(random, 1.0);
    const MeasureFeature moving = cylinder(from, 0.01);
    MeasureFeature fixed = placed(moving, Pose::translation(0.3 * moving.direction));
    fixed.direction = -fixed.direction;
    const Pose motion = alignment(moving, fixed, false);
    EXPECT_LT(motion.position.norm(), 1e-12);
    EXPECT_LT(angleBetween(motion.orientation, Quaternion::Identity()), 1e-7);
  }
}

TEST(Alignment, IsOfTwoPlanesOrTwoCylindersOnly) {
  const MeasureFeature plane = face(Pose::identity());
  const MeasureFeature shaft = cylinder(Pose::identity(), 0.01);
  EXPECT_TRUE(canAlign(plane, plane));
  EXPECT_FALSE(canAlign(plane, shaft));
  EXPECT_FALSE(canAlign(shaft, plane));
  EXPECT_FALSE(canAlign(MeasureFeature(), MeasureFeature()));
}

}  // namespace
}  // namespace glissade
