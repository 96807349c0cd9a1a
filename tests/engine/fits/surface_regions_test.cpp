#include "engine/fits/surface_regions.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/geometry/primitives.h"
#include "tests/engine/fits/ring.h"
#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

constexpr double kRegionsRoom = 0.5;  ///< half width of the space for bodies, metres

TEST(SurfaceRegions, FindTheExactCylindersOfTurnedRingsHoweverCoarse) {
  RandomStream random(7, "rings");
  for (int round = 0; round < 40; ++round) {
    const double inner = 0.001 + 0.02 * random.uniform();
    const double outer = inner + 0.001 + 0.02 * random.uniform();
    const double length = 0.002 + 0.1 * random.uniform();
    const int segments = 12 + static_cast<int>(60.0 * random.uniform());
    const Pose place = randomPose(random, kRegionsRoom);
    const SurfaceRegions found = findSurfaceRegions(transformed(test::makeRing(inner, outer, length, segments), place));
    ASSERT_EQ(found.cylinders.size(), 2U) << "segments " << segments;
    EXPECT_EQ(found.planes.size(), 2U);
    for (const CylinderRegion& cylinder : found.cylinders) {
      EXPECT_NEAR(cylinder.radius, cylinder.shaft ? outer : inner, 1e-7);
      EXPECT_NEAR(cylinder.high - cylinder.low, length, 1e-6);
      EXPECT_NEAR((place.position - cylinder.point).cross(cylinder.direction).norm(), 0.0, 1e-7);
      const double sagitta = cylinder.radius * (1.0 - std::cos(3.14159265358979323846 / segments));
      EXPECT_NEAR(cylinder.sagitta, sagitta, 1e-7);
    }
    EXPECT_NE(found.cylinders[0].shaft, found.cylinders[1].shaft);
  }
}

TEST(SurfaceRegions, TakeAPrismAsPlanes) {
  for (const int sides : {4, 6, 8}) {
    const SurfaceRegions found = findSurfaceRegions(test::makeRing(0.0, 0.01, 0.02, sides));
    EXPECT_TRUE(found.cylinders.empty()) << sides;
    EXPECT_EQ(found.planes.size(), static_cast<std::size_t>(sides) + 2) << sides;
  }
}

/// The mesh with a face for each region that was fitted to it.
TriangleMesh withFaces(TriangleMesh mesh, const std::vector<SurfaceFace>& planes,
                       const std::vector<SurfaceFace>& cylinders) {
  const SurfaceRegions fitted = findSurfaceRegions(mesh);
  EXPECT_EQ(fitted.planes.size(), planes.size());
  EXPECT_EQ(fitted.cylinders.size(), cylinders.size());
  mesh.faces = planes;
  mesh.faces.insert(mesh.faces.end(), cylinders.begin(), cylinders.end());
  for (const SurfaceRegions::Label& label : fitted.labels) {
    const bool plane = label.kind == SurfaceRegions::Kind::Plane;
    mesh.faceOf.push_back(label.index + (plane ? 0U : static_cast<std::uint32_t>(planes.size())));
  }
  return mesh;
}

/// A ring as in a STEP file: radii and axes are the stated ones bit by bit, normals point outwards.
TEST(SurfaceRegions, AreThoseThatTheFileStates) {
  RandomStream random(3, "stated rings");
  for (int round = 0; round < 20; ++round) {
    const double inner = 0.001 + 0.02 * random.uniform();
    const double outer = inner + 0.003;
    const Pose place = randomPose(random, kRegionsRoom);
    const TriangleMesh ring = transformed(test::makeRing(inner, outer, 0.02, 16), place);
    const SurfaceRegions fitted = findSurfaceRegions(ring);
    std::vector<SurfaceFace> planes(2);
    std::vector<SurfaceFace> cylinders(2);
    for (std::size_t i = 0; i < 2; ++i) {
      planes[i] = {SurfaceFace::Kind::Plane, fitted.planes[i].offset * fitted.planes[i].normal};
      planes[i].axis = random.uniform() < 0.5 ? fitted.planes[i].normal : Vector3(-fitted.planes[i].normal);
      cylinders[i] = {SurfaceFace::Kind::Cylinder, place.position, place.orientation * Vector3::UnitZ()};
      cylinders[i].radius = fitted.cylinders[i].shaft ? outer : inner;
    }
    const SurfaceRegions stated = findSurfaceRegions(withFaces(ring, planes, cylinders));
    ASSERT_EQ(stated.cylinders.size(), 2U);
    ASSERT_EQ(stated.planes.size(), 2U);
    for (const CylinderRegion& cylinder : stated.cylinders) {
      EXPECT_EQ(cylinder.radius, cylinder.shaft ? outer : inner);
      EXPECT_NEAR(cylinder.high - cylinder.low, 0.02, 1e-9);
    }
    for (const PlaneRegion& plane : stated.planes) {
      EXPECT_GT(plane.offset - plane.normal.dot(place.position), 0.009) << "outwards";
    }
    // A statement that the triangles contradict is not used: the radii are those of the triangles.
    for (SurfaceFace& cylinder : cylinders) cylinder.radius *= 1.01;
    for (const CylinderRegion& cylinder : findSurfaceRegions(withFaces(ring, planes, cylinders)).cylinders) {
      EXPECT_NEAR(cylinder.radius, cylinder.shaft ? outer : inner, 1e-7);
    }
    // A stated cone is no cylinder, even if its triangles look like one; if they contradict the statement, it is not
    // used.
    for (SurfaceFace& cylinder : cylinders) cylinder.kind = SurfaceFace::Kind::Cone;
    const SurfaceRegions cones = findSurfaceRegions(withFaces(ring, planes, cylinders));
    EXPECT_TRUE(cones.cylinders.empty());
    EXPECT_TRUE(cones.rounds.empty()) << "their radii are those of no vertex";
  }
}

TEST(SurfaceRegions, LeaveASphereFree) {
  const SurfaceRegions found = findSurfaceRegions(makeSphere(0.02, 3));
  EXPECT_TRUE(found.cylinders.empty());
  const auto isFree = [](const SurfaceRegions::Label& label) { return label.kind == SurfaceRegions::Kind::Free; };
  EXPECT_TRUE(std::all_of(found.labels.begin(), found.labels.end(), isFree));
}

}  // namespace
}  // namespace glissade
