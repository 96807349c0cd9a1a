#include "engine/fits/alignment.h"

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

/// Random poses, and poses with nearly equal or nearly opposite directions, where digits are easily lost.
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

/// Features that are aligned do not move, except for the last digits.
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

MeasureFeature edge(const Pose& X_WF) {
  MeasureFeature feature = face(X_WF);
  feature.kind = Kind::Edge;
  feature.from = X_WF * Vector3(0.0, 0.0, -0.1);
  feature.to = X_WF * Vector3(0.0, 0.0, 0.2);
  return feature;
}

MeasureFeature vertex(const Pose& X_WF) {
  MeasureFeature feature;
  feature.kind = Kind::Vertex;
  feature.picked = X_WF.position;
  return feature;
}

double heightOver(const MeasureFeature& plane, const Vector3& p) { return plane.direction.dot(p - plane.picked); }

double angleOf(const Pose& motion) { return angleBetween(motion.orientation, Quaternion::Identity()); }

/// A hundredth of a nanometre, as in the whole test, for features two metres away.
constexpr double kRelated = 1e-9;

TEST(Alignment, AnEdgeLiesInThePlaneWhicheverOfTheTwoMoves) {
  for (const auto& [from, to] : pairsOfPoses()) {
    for (const bool flipped : {false, true}) {
      const MeasureFeature plane = face(to);
      const MeasureFeature movedEdge = placed(edge(from), alignment(edge(from), plane, flipped));
      EXPECT_NEAR(heightOver(plane, movedEdge.from), 0.0, kRelated);
      EXPECT_NEAR(heightOver(plane, movedEdge.to), 0.0, kRelated);
      const MeasureFeature movedPlane = placed(face(from), alignment(face(from), edge(to), flipped));
      EXPECT_NEAR(heightOver(movedPlane, edge(to).from), 0.0, kRelated);
      EXPECT_NEAR(heightOver(movedPlane, edge(to).to), 0.0, kRelated);
    }
    // The flip is half a turn about the edge.
    const Pose one = alignment(face(from), edge(to), false);
    const Pose other = alignment(face(from), edge(to), true);
    EXPECT_LT((placed(face(from), one).direction + placed(face(from), other).direction).norm(), kRelated);
  }
}

TEST(Alignment, ACylinderIsTangentToThePlaneWhicheverOfTheTwoMoves) {
  constexpr double kRadius = 0.07;
  for (const auto& [from, to] : pairsOfPoses()) {
    for (const bool hole : {false, true}) {
      for (const bool flipped : {false, true}) {
        const double height = hole != flipped ? -kRadius : kRadius;
        MeasureFeature round = cylinder(from, kRadius);
        round.isHole = hole;
        const MeasureFeature plane = face(to);
        const MeasureFeature moved = placed(round, alignment(round, plane, flipped));
        EXPECT_NEAR(heightOver(plane, moved.axisPoint), height, kRelated);
        EXPECT_NEAR(heightOver(plane, moved.axisPoint + moved.direction), height, kRelated);
        const MeasureFeature movedPlane = placed(plane, alignment(plane, round, flipped));
        EXPECT_NEAR(heightOver(movedPlane, round.axisPoint), height, kRelated);
        EXPECT_NEAR(heightOver(movedPlane, round.axisPoint + round.direction), height, kRelated);
      }
    }
  }
}

TEST(Alignment, EdgesAreCollinearWithEdgesAndAxes) {
  for (const auto& [from, to] : pairsOfPoses()) {
    for (const bool flipped : {false, true}) {
      MeasureFeature axis = cylinder(to, 0.02);
      for (const MeasureFeature& fixed : {edge(to), axis}) {
        const MeasureFeature moved = placed(edge(from), alignment(edge(from), fixed, flipped));
        const Vector3& on = fixed.kind == Kind::Edge ? fixed.picked : fixed.axisPoint;
        EXPECT_LT((moved.from - on).cross(fixed.direction).norm(), kRelated);
        EXPECT_LT((moved.to - on).cross(fixed.direction).norm(), kRelated);
        EXPECT_EQ(moved.direction.dot(fixed.direction) > 0.0,
                  (edge(from).direction.dot(fixed.direction) >= 0.0) != flipped);
      }
    }
  }
}

/// The body does not turn; it moves by the former distance.
TEST(Alignment, AVertexComesOntoAVertexALineOrAPlaneByTheShortestWay) {
  for (const auto& [from, to] : pairsOfPoses()) {
    const MeasureFeature point = vertex(from);
    for (const MeasureFeature& other : {vertex(to), edge(to), cylinder(to, 0.01), face(to)}) {
      for (const bool moves : {true, false}) {
        const Pose motion = moves ? alignment(point, other, false) : alignment(other, point, false);
        EXPECT_EQ(angleOf(motion), 0.0);
        EXPECT_FALSE(canFlip(point, other));
        EXPECT_FALSE(canFlip(other, point));
        const Vector3 p = moves ? Vector3(motion * point.picked) : point.picked;
        const MeasureFeature there = moves ? other : placed(other, motion);
        const Vector3 anchor = other.kind == Kind::Cylinder ? other.axisPoint : other.picked;
        const Vector3 apart = point.picked - anchor;
        double before = apart.norm();
        double after = (p - there.picked).norm();
        if (other.kind == Kind::Face) {
          before = std::abs(apart.dot(other.direction));
          after = std::abs(heightOver(there, p));
        } else if (other.kind != Kind::Vertex) {
          before = apart.cross(other.direction).norm();
          after = (p - (other.kind == Kind::Edge ? there.picked : there.axisPoint)).cross(there.direction).norm();
        }
        EXPECT_NEAR(motion.position.norm(), before, kRelated);
        EXPECT_LT(after, kRelated);
      }
    }
  }
}

/// A line turns into the plane by its angle to the plane.
TEST(Alignment, ALineTurnsByItsAngleToThePlaneAndNoMore) {
  for (const auto& [from, to] : pairsOfPoses()) {
    const double angle = std::asin(std::min(1.0, std::abs(edge(from).direction.dot(face(to).direction))));
    EXPECT_NEAR(angleOf(alignment(edge(from), face(to), false)), angle, 1e-6);
    EXPECT_NEAR(angleOf(alignment(face(to), edge(from), false)), angle, 1e-6);
    EXPECT_NEAR(angleOf(alignment(cylinder(from, 0.1), face(to), true)), angle, 1e-6);
  }
}

TEST(Alignment, IsOfAllButPointsOfFreeSurfaces) {
  const std::vector<MeasureFeature> features{face({}), edge({}), cylinder({}, 0.01), vertex({})};
  for (const MeasureFeature& moving : features) {
    for (const MeasureFeature& fixed : features) EXPECT_TRUE(canAlign(moving, fixed));
    EXPECT_FALSE(canAlign(moving, MeasureFeature()));
    EXPECT_FALSE(canAlign(MeasureFeature(), moving));
  }
  EXPECT_TRUE(canFlip(face({}), cylinder({}, 0.01)));
  EXPECT_TRUE(canFlip(edge({}), face({})));
}

}  // namespace
}  // namespace glissade
