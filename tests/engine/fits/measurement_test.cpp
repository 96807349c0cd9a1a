#include "engine/fits/measurement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/geometry/primitives.h"
#include "engine/geometry/triangle_tree.h"
#include "engine/import/step_import.h"
#include "tests/engine/fits/ring.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/step_files.h"

namespace glissade {
namespace {

using Kind = MeasureFeature::Kind;

MeshPtr boxMesh(const Vector3& size) { return std::make_shared<const TriangleMesh>(welded(makeBox(size))); }

/// The feature at a point of the mesh's surface.
MeasureFeature featureNear(const MeshPtr& mesh, const Vector3& p, double snap) {
  const TriangleTree::Nearest nearest = TriangleTree(*mesh).nearest(p, 10.0);
  return MeasurableMesh(mesh).featureAt(nearest.triangle, p, snap);
}

TEST(Measurement, SnapsToVerticesThenEdgesThenFaces) {
  const MeshPtr box = boxMesh({0.2, 0.4, 0.6});
  const Vector3 corner(0.1, 0.2, 0.3);
  const MeasureFeature vertex = featureNear(box, corner - Vector3(0.001, 0.001, 0.0), 0.005);
  EXPECT_EQ(vertex.kind, Kind::Vertex);
  EXPECT_LT((vertex.picked - corner).norm(), 1e-12);
  const MeasureFeature edge = featureNear(box, {0.1, 0.05, 0.299}, 0.005);
  EXPECT_EQ(edge.kind, Kind::Edge);
  EXPECT_NEAR((edge.to - edge.from).norm(), 0.4, 1e-12);
  // The diagonals of the triangles are no edges of the body.
  for (const double y : {-0.1, 0.0, 0.1}) {
    const MeasureFeature face = featureNear(box, {0.1, y, 1.5 * y}, 0.005);
    EXPECT_EQ(face.kind, Kind::Face);
    EXPECT_NEAR(std::abs(face.direction.x()), 1.0, 1e-12);
  }
}

TEST(Measurement, ReadsTheExactRadiusOfACoarseCylinder) {
  const auto ring = std::make_shared<const TriangleMesh>(welded(test::makeRing(0.02, 0.05, 0.1, 16)));
  const double facet = 0.05 * std::cos(std::numbers::pi / 16.0);
  const Vector3 middle = facet * Vector3(std::cos(std::numbers::pi / 16.0), std::sin(std::numbers::pi / 16.0), 0.0);
  const MeasureFeature outside = featureNear(ring, middle, 0.0);
  ASSERT_EQ(outside.kind, Kind::Cylinder);
  EXPECT_NEAR(outside.radius, 0.05, 1e-9);
}

/// A click on the edge of a hole means the axis of the hole.
TEST(Measurement, TheCircularEdgeOfACylinderMeansItsAxisInAnAlignment) {
  const MeshPtr ring = std::make_shared<const TriangleMesh>(welded(test::makeRing(0.02, 0.05, 0.1, 16)));
  const Vector3 onTop(0.0205 * std::cos(std::numbers::pi / 16.0), 0.0205 * std::sin(std::numbers::pi / 16.0), 0.05);
  const TriangleTree::Nearest nearest = TriangleTree(*ring).nearest(onTop, 10.0);
  const MeasurableMesh measurable(ring);
  EXPECT_EQ(measurable.featureAt(nearest.triangle, onTop, 0.003).kind, Kind::Edge);
  const MeasureFeature hole = measurable.alignableAt(nearest.triangle, onTop, 0.003);
  ASSERT_EQ(hole.kind, Kind::Cylinder);
  EXPECT_TRUE(hole.isHole);
  EXPECT_NEAR(hole.radius, 0.02, 1e-9);
  EXPECT_EQ(measurable.alignableAt(nearest.triangle, onTop, 0.0001).kind, Kind::Face);
  const MeshPtr box = boxMesh({0.2, 0.4, 0.6});
  const MeasurableMesh boxes(box);
  const Vector3 nearEdge(0.1, 0.05, 0.299);
  const std::size_t triangle = TriangleTree(*box).nearest(nearEdge, 10.0).triangle;
  EXPECT_EQ(boxes.alignableAt(triangle, nearEdge, 0.005).kind, Kind::Edge);
  EXPECT_EQ(boxes.outlineAt(triangle).size(), 8U) << "the four edges of the face";
}

TEST(Measurement, DistancesDoNotDependOnTheFrame) {
  RandomStream random(5, "measurement");
  const MeasureFeature top{Kind::Face, {0.0, 0.0, 0.3}, {}, {}, Vector3::UnitZ(), Vector3::Zero(), 0.0};
  const MeasureFeature shelf{Kind::Face, {5.0, 1.0, 0.1}, {}, {}, -Vector3::UnitZ(), Vector3::Zero(), 0.0};
  const MeasureFeature vertex{Kind::Vertex, {1.0, 2.0, 3.3}, {}, {}, Vector3::UnitZ(), Vector3::Zero(), 0.0};
  const MeasureFeature axis{Kind::Cylinder, Vector3::Zero(), {}, {}, Vector3::UnitX(), {0.0, 0.0, 0.0}, 0.1};
  const MeasureFeature edge{Kind::Edge, {0, 0.5, 1}, {0, 0.5, 1}, {0, 2.5, 1}, Vector3::UnitY(), Vector3::Zero(), 0.0};
  for (int round = 0; round < 20; ++round) {
    const Pose X = randomPose(random, 2.0);
    const auto distance = [&X](const MeasureFeature& a, const MeasureFeature& b) {
      const MeasuredDistance one = distanceBetween(placed(a, X), placed(b, X));
      const MeasuredDistance other = distanceBetween(placed(b, X), placed(a, X));
      EXPECT_NEAR(one.metres, other.metres, 1e-9);
      EXPECT_NEAR((one.to - one.from).norm(), one.metres, 1e-9);
      return one.metres;
    };
    EXPECT_NEAR(distance(top, shelf), 0.2, 1e-9);
    EXPECT_NEAR(distance(top, vertex), 3.0, 1e-9);
    EXPECT_NEAR(distance(axis, vertex), std::hypot(2.0, 3.3), 1e-9);
    EXPECT_NEAR(distance(axis, edge), std::hypot(0.5, 1.0), 1e-9) << "the nearer end of the edge";
    EXPECT_NEAR(distance(top, edge), 0.7, 1e-9);
    EXPECT_NEAR(distance(vertex, vertex), 0.0, 1e-12);
  }
}

TEST(Measurement, AFaceAndAnAxisHaveAFrameToPlaceBy) {
  const auto frameNear = [](const MeshPtr& mesh, const Vector3& p) {
    return MeasurableMesh(mesh).frameAt(TriangleTree(*mesh).nearest(p, 10.0).triangle);
  };
  const auto face = frameNear(boxMesh({0.2, 0.4, 0.6}), {0.03, -0.2, 0.11});
  ASSERT_TRUE(face);
  EXPECT_TRUE(face->position.isApprox(Vector3(0.0, -0.2, 0.0), 1e-12)) << "the middle of the face";
  EXPECT_TRUE((face->orientation * Vector3::UnitZ()).isApprox(-Vector3::UnitY(), 1e-12));
  EXPECT_TRUE((face->orientation * Vector3::UnitX()).isApprox(Vector3::UnitX(), 1e-12));
  const Pose place{Vector3(0.1, 0.2, 0.3), Quaternion(Eigen::AngleAxisd(2.0, Vector3(1.0, 2.0, 3.0).normalized()))};
  const auto ring = std::make_shared<const TriangleMesh>(transformed(test::makeRing(0.005, 0.01, 0.02, 30), place));
  const auto axis = frameNear(ring, place * Vector3(0.01, 0.0, 0.004));
  ASSERT_TRUE(axis);
  EXPECT_TRUE(axis->position.isApprox(place.position, 1e-7)) << "the middle of the hole's or the shaft's axis";
  const Vector3 direction = axis->orientation * Vector3::UnitZ();
  EXPECT_LT(direction.cross(place.orientation * Vector3::UnitZ()).norm(), 1e-6);
  EXPECT_GT(direction.maxCoeff(), -direction.minCoeff()) << "towards its largest coordinate";
  EXPECT_FALSE(frameNear(std::make_shared<const TriangleMesh>(makeSphere(0.1)), {0.1, 0.0, 0.0}));
}

TEST(Measurement, AnglesAreBetweenEdgesAxesAndPlanes) {
  const auto along = [](Kind kind, const Vector3& direction) {
    return MeasureFeature{kind, Vector3::Zero(), Vector3::Zero(), direction, direction.normalized(), Vector3::Zero(),
                          0};
  };
  const Vector3 tilted(1.0, 0.0, std::sqrt(3.0));  // 60 degrees above x
  const double sixty = std::numbers::pi / 3.0;
  EXPECT_NEAR(*angleBetweenFeatures(along(Kind::Edge, Vector3::UnitX()), along(Kind::Edge, -tilted)), sixty, 1e-12);
  EXPECT_NEAR(*angleBetweenFeatures(along(Kind::Face, Vector3::UnitX()), along(Kind::Face, tilted)), sixty, 1e-12);
  EXPECT_NEAR(*angleBetweenFeatures(along(Kind::Face, Vector3::UnitZ()), along(Kind::Cylinder, tilted)), sixty, 1e-12);
  EXPECT_FALSE(angleBetweenFeatures(along(Kind::Vertex, tilted), along(Kind::Edge, tilted)));
}

/// The feature at a point of a part of round-fits.step, millimetres in the file.
MeasureFeature roundFeature(const std::string& name, const Vector3& p_F) {
  const auto file = importStep(test::stepFile("round-fits.step"), 0.0);
  EXPECT_TRUE(file);
  if (!file) return {};
  for (const Occurrence& part : file->parts) {
    if (part.path == name)
      return placed(featureNear(part.mesh, inverse(part.X_FP) * Vector3(1e-3 * p_F), 0.0), part.X_FP);
  }
  ADD_FAILURE() << "no part " << name;
  return {};
}

TEST(Measurement, ReadsConesSpheresAndToriAsTheFileStatesThem) {
  const MeasureFeature cone = roundFeature("seated", {-25.0, -3.0, 5.0});
  ASSERT_EQ(cone.kind, Kind::Cone);
  EXPECT_NEAR(cone.halfAngle, std::numbers::pi / 4.0, 1e-12);
  EXPECT_NEAR(cone.radius, 3e-3, 1e-9) << "beside the point";
  EXPECT_NEAR((cone.axisPoint - Vector3(-25e-3, 0.0, 5e-3)).norm(), 0.0, 1e-9);
  EXPECT_FALSE(cone.isHole);
  const MeasureFeature countersink = roundFeature("plate", {0.0, 3.0, 5.0});
  ASSERT_EQ(countersink.kind, Kind::Cone);
  EXPECT_TRUE(countersink.isHole);
  const MeasureFeature ball = roundFeature("ball", {10.0, 0.0, 63.0});
  ASSERT_EQ(ball.kind, Kind::Sphere);
  EXPECT_NEAR(ball.radius, 3e-3, 1e-12);
  EXPECT_NEAR((ball.axisPoint - Vector3(10e-3, 0.0, 60e-3)).norm(), 0.0, 1e-12);
  const MeasureFeature groove = roundFeature("race", {0.0, 10.0, 57.0});
  ASSERT_EQ(groove.kind, Kind::Torus);
  EXPECT_NEAR(groove.radius, 10e-3, 1e-12);
  EXPECT_NEAR(groove.tubeRadius, 3e-3, 1e-12);
  EXPECT_TRUE(groove.isHole);
  EXPECT_NEAR(distanceBetween(cone, groove).metres, 25e-3, 1e-9) << "between axes";
  EXPECT_NEAR(distanceBetween(ball, groove).metres, 10e-3, 1e-9) << "of the centre from the axis";
  EXPECT_NEAR(*angleBetweenFeatures(cone, groove), 0.0, 1e-9);
  EXPECT_FALSE(angleBetweenFeatures(ball, groove)) << "a sphere has no direction";
}

}  // namespace
}  // namespace glissade
