#include "engine/geometry/plane_section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "engine/base/random_stream.h"
#include "engine/geometry/primitives.h"

namespace glissade {
namespace {

/// Signed area: counter-clockwise seen against the normal is positive.
double areaOf(const std::vector<Vector3>& polygon, const Vector3& normal) {
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < polygon.size(); ++i) sum += polygon[i].cross(polygon[(i + 1) % polygon.size()]);
  return 0.5 * sum.dot(normal);
}

double areaOf(const std::vector<std::vector<Vector3>>& polygons, const Vector3& normal) {
  return std::accumulate(polygons.begin(), polygons.end(), 0.0, [&](double sum, const std::vector<Vector3>& polygon) {
    return sum + areaOf(polygon, normal);
  });
}

TEST(PlaneSection, ABoxHasARectangle) {
  const TriangleMesh box = makeBox({0.2, 0.3, 0.4});
  const auto section = planeSection(box, {Vector3::UnitZ(), 0.05});
  ASSERT_EQ(section.size(), 1U);
  EXPECT_NEAR(areaOf(section, Vector3::UnitZ()), 0.06, 1e-12);
  for (const Vector3& point : section[0]) EXPECT_NEAR(point.z(), 0.05, 1e-15);
}

TEST(PlaneSection, NothingBesideTheMesh) {
  EXPECT_TRUE(planeSection(makeBox({1, 1, 1}), {Vector3::UnitX(), 0.6}).empty());
  EXPECT_TRUE(planeSection(makeBox({1, 1, 1}), {Vector3::UnitX(), -0.6}).empty());
}

TEST(PlaneSection, AFaceInThePlaneIsCutOnOneSideOnly) {
  const TriangleMesh box = makeBox({1, 1, 1});
  EXPECT_EQ(planeSection(box, {Vector3::UnitX(), 0.5}).size(), 1U);
  EXPECT_EQ(planeSection(box, {Vector3::UnitX(), -0.5}).size(), 0U);
}

TEST(PlaneSection, AFaceIsInThePlaneWhateverItsCoordinatesAreRoundedTo) {
  RandomStream random(3, "rounded faces");
  for (int round = 0; round < 20; ++round) {
    TriangleMesh box = makeBox({1, 1, 1});
    for (Vector3& vertex : box.vertices) vertex.x() += random.uniform(-1e-7, 1e-7);
    EXPECT_NEAR(areaOf(planeSection(box, {Vector3::UnitX(), 0.5}), Vector3::UnitX()), 1.0, 1e-5);
    EXPECT_TRUE(planeSection(box, {Vector3::UnitX(), -0.5}).empty());
  }
}

TEST(PlaneSection, TheHoleOfAHollowBodyIsAPolygonOfTheOtherDirection) {
  TriangleMesh hollow = makeBox({1, 1, 1});
  TriangleMesh inner = makeBox({0.5, 0.5, 0.5});
  for (TriangleIndices& triangle : inner.triangles) std::swap(triangle[0], triangle[1]);
  append(hollow, inner);
  const auto section = planeSection(hollow, {Vector3::UnitY(), 0.1});
  EXPECT_EQ(section.size(), 2U);
  EXPECT_NEAR(areaOf(section, Vector3::UnitY()), 0.75, 1e-12);
}

TEST(PlaneSection, AreasOfParallelPlanesAddUpToTheVolume) {
  RandomStream random(7, "plane sections");
  const TriangleMesh box = makeBox({0.3, 0.5, 0.7});
  for (int round = 0; round < 20; ++round) {
    Vector3 normal(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    normal.normalize();
    constexpr int kPlanes = 4000;
    double volume = 0.0;
    for (int i = 0; i < kPlanes; ++i) {
      const double offset = -0.5 + (i + 0.5) / kPlanes;
      volume += areaOf(planeSection(box, {normal, offset}), normal) / kPlanes;
    }
    EXPECT_NEAR(volume, 0.3 * 0.5 * 0.7, 1e-5);
  }
}

TEST(PlaneSection, APlaneInTheBodysFrameCutsTheSamePoints) {
  const TriangleMesh box = makeBox({0.3, 0.5, 0.7});
  const Pose X_WB{Vector3(0.1, -0.2, 0.3), Quaternion(Eigen::AngleAxisd(0.8, Vector3(1, 2, 3).normalized()))};
  const Plane plane{Vector3(0.2, -0.5, 0.7).normalized(), 0.21};
  const auto inBody = planeSection(box, planeInBody(plane, X_WB));
  ASSERT_EQ(inBody.size(), 1U);
  for (const Vector3& point : inBody[0]) EXPECT_NEAR(plane.normal.dot(X_WB * point), plane.offset, 1e-12);
  EXPECT_NEAR(areaOf(inBody, planeInBody(plane, X_WB).normal),
              areaOf(planeSection(transformed(box, X_WB), plane), plane.normal), 1e-12);
}

TEST(PlaneSection, CurvesOfAnOpenMeshAreLeftOut) {
  TriangleMesh box = makeBox({1, 1, 1});
  box.triangles.erase(box.triangles.begin(), box.triangles.begin() + 2);
  bool anyOpen = false;
  for (const Vector3& normal : {Vector3(Vector3::UnitX()), Vector3(Vector3::UnitY()), Vector3(Vector3::UnitZ())}) {
    for (const auto& polygon : planeSection(box, {normal, 0.1})) EXPECT_GT(std::abs(areaOf(polygon, normal)), 0.5);
    anyOpen = anyOpen || planeSection(box, {normal, 0.1}).empty();
  }
  EXPECT_TRUE(anyOpen);
}

}  // namespace
}  // namespace glissade
