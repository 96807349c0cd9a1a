#include "engine/fits/feature_snap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "engine/geometry/primitives.h"
#include "engine/import/step_import.h"
#include "tests/engine/fits/ring.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/step_files.h"

namespace glissade {
namespace {

using SnapKind = SnapFeature::Kind;

std::vector<SnapFeature> featuresOf(const TriangleMesh& mesh, const Pose& X_WB) {
  std::vector<SnapFeature> features =
      findSnapFeatures(MeasurableMesh(std::make_shared<const TriangleMesh>(welded(mesh))));
  for (SnapFeature& feature : features) feature = placed(feature, X_WB);
  return features;
}

/// The gap between the features of a pair, metres.
double gapOf(const FeatureSnapper& snapper, const FeatureSnap::Pair& pair, const Vector3& shift) {
  const SnapFeature& fixed = snapper.fixed()[pair.fixed];
  const Vector3 apart = snapper.moving()[pair.moving].point + shift - fixed.point;
  return fixed.kind == SnapKind::Plane ? std::abs(apart.dot(fixed.direction)) : apart.cross(fixed.direction).norm();
}

TEST(SnapFeatures, ATurnedPartOfConesAndToriHasItsAxis) {
  const auto file = importStep(test::stepFile("round-fits.step"), 0.0);
  ASSERT_TRUE(file);
  std::map<std::string, std::size_t> axes;
  for (const Occurrence& part : file->parts) {
    for (const SnapFeature& feature : featuresOf(*part.mesh, part.X_FP))
      axes[part.path] += feature.kind == SnapKind::Axis;
  }
  EXPECT_EQ(axes["seated"], 1U) << "cone and shaft have one";
  EXPECT_EQ(axes["plate"], 3U);
  EXPECT_EQ(axes["race"], 1U) << "of the torus";
  EXPECT_EQ(axes["ball"], 0U);
}

TEST(SnapFeatures, OfABoxAreItsFacesAndOfARingItsEndsAndItsAxis) {
  const std::vector<SnapFeature> box = featuresOf(makeBox({0.2, 0.4, 0.6}), Pose::identity());
  ASSERT_EQ(box.size(), 6U);
  for (const SnapFeature& face : box) {
    EXPECT_EQ(face.kind, SnapKind::Plane);
    EXPECT_GT(face.point.dot(face.direction), 0.09) << "outwards";
    EXPECT_NEAR(face.box.diagonal().dot(face.direction), 0.0, 1e-12);
  }
  const Pose X_WB = Pose::translation({1.0, 2.0, 3.0});
  const std::vector<SnapFeature> ring = featuresOf(test::makeRing(0.02, 0.05, 0.1, 24), X_WB);
  ASSERT_EQ(ring.size(), 3U) << "hole and shaft have one axis";
  EXPECT_EQ(ring[2].kind, SnapKind::Axis);
  EXPECT_LT((ring[2].point - X_WB.position).norm(), 1e-9);
  EXPECT_NEAR(ring[2].box.diagonal().norm(), 0.1, 1e-9);
}

/// One to three orthonormal directions.
std::vector<Vector3> randomFreedom(RandomStream& random) {
  const Quaternion turn = randomPose(random, 1.0).orientation;
  std::vector<Vector3> freedom;
  const int directions = 1 + static_cast<int>(random.uniform() * 2.999);
  for (int axis = 0; axis < directions; ++axis) {
    freedom.push_back(random.uniform() < 0.5 ? Vector3(turn * Vector3::Unit(axis)) : Vector3(Vector3::Unit(axis)));
    for (std::size_t i = 0; i + 1 < freedom.size(); ++i) {
      freedom.back() -= freedom.back().dot(freedom[i]) * freedom[i];
    }
    freedom.back().normalize();
  }
  return freedom;
}

TEST(FeatureSnap, PairsMeetWithinTheReachAndTheFreedom) {
  RandomStream random(23, "feature snap");
  int snaps = 0;
  int doubles = 0;
  for (int i = 0; i < 400; ++i) {
    const Pose X = randomPose(random, 1.0);
    const bool round = i % 2 == 0;
    const TriangleMesh part = round ? test::makeRing(0.0, 0.1, 0.3, 16) : makeBox({0.2, 0.3, 0.4});
    const TriangleMesh other = round ? test::makeRing(0.1, 0.2, 0.2, 24) : makeBox({0.5, 0.5, 0.1});
    const Vector3 apart = 0.3 * randomPose(random, 1.0).position;
    const FeatureSnapper snapper(featuresOf(part, X), featuresOf(other, Pose::translation(apart) * X), 0.5);
    std::vector<Vector3> freedom = randomFreedom(random);
    for (Vector3& direction : freedom) direction = X.orientation * direction;
    Vector3 shift = Vector3::Zero();
    for (const Vector3& direction : freedom) shift += random.uniform(-0.3, 0.3) * direction;
    const double reach = random.uniform(0.01, 0.1);
    const FeatureSnap snap = snapper.snap(shift, freedom, reach);
    EXPECT_TRUE(!snap.pairs.empty() || snap.shift == shift);
    Vector3 across = snap.shift;
    for (const Vector3& direction : freedom) across -= across.dot(direction) * direction;
    EXPECT_LT(across.norm(), 1e-12) << "the freedom";
    EXPECT_LE((snap.shift - shift).norm(), reach * std::sqrt(3.0)) << "each step is within the reach";
    for (const FeatureSnap::Pair& pair : snap.pairs) EXPECT_LT(gapOf(snapper, pair, snap.shift), 1e-9);
    snaps += snap.pairs.empty() ? 0 : 1;
    doubles += snap.pairs.size() > 1 ? 1 : 0;
  }
  EXPECT_GT(snaps, 60);
  EXPECT_GT(doubles, 20);
}

/// Compares with the nearest of all steps, found by trying every pair.
TEST(FeatureSnap, AnArrowSnapsToTheNearestFace) {
  const std::vector<SnapFeature> moving = featuresOf(makeBox({0.2, 0.2, 0.2}), Pose::identity());
  std::vector<SnapFeature> fixed = featuresOf(makeBox({0.1, 0.3, 0.3}), Pose::translation({1.0, 0.0, 0.0}));
  const FeatureSnapper snapper(moving, fixed, 0.35);
  const std::vector<Vector3> alongX{Vector3::UnitX()};
  const FeatureSnap onto = snapper.snap({0.853, 0.0, 0.0}, alongX, 0.01);
  ASSERT_EQ(onto.pairs.size(), 1U);
  EXPECT_NEAR(onto.shift.x(), 0.85, 1e-12) << "its front lies on the other's back";
  const FeatureSnap level = snapper.snap({0.955, 0.0, 0.0}, alongX, 0.01);
  EXPECT_NEAR(level.shift.x(), 0.95, 1e-12) << "two fronts are level";
  EXPECT_TRUE(snapper.snap({0.7, 0.0, 0.0}, alongX, 0.01).pairs.empty());
  EXPECT_TRUE(snapper.snap({0.853, 2.0, 0.0}, alongX, 0.01).pairs.empty()) << "they are far apart along the face";
}

/// An arrow across the axis lets axes meet only in its direction; a square does in both.
TEST(FeatureSnap, AnAxisSnapsWhereTheFreedomLetsItMeet) {
  const std::vector<SnapFeature> pin = featuresOf(test::makeRing(0.0, 0.01, 0.1, 16), Pose::identity());
  const auto snapperOf = [&](const Vector3& at) {
    return FeatureSnapper(pin, featuresOf(test::makeRing(0.01, 0.05, 0.02, 16), Pose::translation(at)), 0.1);
  };
  const FeatureSnap lined = snapperOf({0.2, 0.0, 0.1}).snap({0.198, 0.0, 0.0}, {Vector3::UnitX()}, 0.005);
  ASSERT_EQ(lined.pairs.size(), 1U);
  EXPECT_NEAR(lined.shift.x(), 0.2, 1e-9);
  EXPECT_TRUE(snapperOf({0.2, 0.002, 0.1}).snap({0.198, 0.0, 0.0}, {Vector3::UnitX()}, 0.005).pairs.empty());
  const FeatureSnap both =
      snapperOf({0.2, 0.002, 0.1}).snap({0.198, 0.0, 0.0}, {Vector3::UnitX(), Vector3::UnitY()}, 0.005);
  ASSERT_EQ(both.pairs.size(), 1U);
  EXPECT_LT((both.shift - Vector3(0.2, 0.002, 0.0)).norm(), 1e-9);
}

}  // namespace
}  // namespace glissade
