#include "engine/evidence/face_patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/evidence/evidence.h"
#include "engine/evidence/thinning.h"
#include "engine/geometry/triangle_tree.h"
#include "tests/engine/check/check_bodies.h"

namespace glissade::check {
namespace {

PlacedBody inPlace(const Body& body) { return PlacedBody(body, body.X_WB); }

AllowanceBound boundOf(const Body& one, const Body& other) {
  const PlacedBody a = inPlace(one);
  const PlacedBody b = inPlace(other);
  const MeasuredPair pair = measurePair(a, b, {});
  return check::boundsOf(MeasuredBody{a, pair.one}, MeasuredBody{b, pair.other}, FitWords{true, 0.0, {}}, nullptr).one;
}

/// The allowance at a point of the surface, world frame. `own`: the mesh of the body, for bounds without a mesh.
double allowedAt(const AllowanceBound& bound, const Vector3& p, const MeshPtr& own = nullptr) {
  return bound.atMost[TriangleTree(bound.mesh ? *bound.mesh : *own).nearest(p, 1.0).triangle];
}

double areaOf(const TriangleMesh& mesh) {
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    area += 0.5 * (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
  }
  return area;
}

TEST(FacePatches, AnOverlapCountsWhereItIs) {
  const Body slab = test::checkBody("slab", makeBox({0.1, 0.04, 0.02}));
  TriangleMesh bosses = makeBox({0.006, 0.006, 0.01});
  for (Vector3& v : bosses.vertices) v += Vector3(-0.04, 0.0, 0.015 - 9e-4);
  append(bosses, transformed(makeBox({0.006, 0.006, 0.01}), Pose::translation({0.03, 0.01, 0.015 - 1e-4})));
  const AllowanceBound bound = boundOf(slab, test::checkBody("bosses", bosses));
  ASSERT_TRUE(bound.mesh);
  EXPECT_NEAR(areaOf(*bound.mesh), areaOf(*slab.mesh), 1e-12) << "the surface is the same";
  EXPECT_NEAR(allowedAt(bound, {-0.04, 0.0, 0.01}), 9e-4, 1e-5);
  EXPECT_NEAR(allowedAt(bound, {0.03, 0.01, 0.01}), 1e-4, 1e-5) << "each patch has its own depth";
  EXPECT_LT(allowedAt(bound, {0.045, -0.012, 0.01}), 1e-5) << "no more than the margin elsewhere";
  EXPECT_LT(allowedAt(bound, {0.0, 0.0, 0.01}), 1e-5);
}

TEST(FacePatches, TheTriangulationFitsTogether) {
  const Body slab = test::checkBody("slab", makeBox({0.1, 0.04, 0.02}));
  const Body boss = test::checkBody("boss", makeBox({0.007, 0.005, 0.01}), {0.021, 0.003, 0.0145});
  const AllowanceBound bound = boundOf(slab, boss);
  ASSERT_TRUE(bound.mesh);
  const PlacedBody fine = inPlace({"fine", "fine", bound.mesh, Pose::identity()});
  EXPECT_TRUE(fine.interior) << "no edge is open";
  const TriangleMesh thin = thinned(*bound.mesh, bound.atMost);
  const TriangleTree tree(thin);
  EXPECT_GT(tree.nearest({0.021, 0.003, 0.01}, 1.0).distance, 4e-4) << "all of the depth in the middle";
  EXPECT_GT(tree.nearest({0.021 + 0.0035, 0.003 + 0.0025, 0.01}, 1.0).distance, 4e-4) << "and at the corners";
  EXPECT_LT(tree.nearest({-0.03, -0.01, 0.01}, 1.0).distance, 1e-5);
}

TEST(FacePatches, TheWallOfAHoleIsOnePatchAndAShaftIsNot) {
  const Body hole = test::checkBody("hole", test::holedPlate(36, 0.01, 0.05, 0.0, 0.06));
  const Body shaft = test::checkBody("shaft", test::prism(36, 0.0101, 0.06), {0.0, 0.0, -0.04});
  const AllowanceBound ofHole = boundOf(hole, shaft);
  EXPECT_FALSE(ofHole.mesh) << "whole triangles";
  EXPECT_GT(allowedAt(ofHole, {0.01, 0.0, 0.055}, hole.mesh), 9e-5)
      << "the shaft is not there, and the hole has one radius";
  const AllowanceBound ofShaft = boundOf(shaft, hole);
  ASSERT_TRUE(ofShaft.mesh);
  EXPECT_GT(allowedAt(ofShaft, {0.0101, 0.0, 0.01}), 9e-5);
  EXPECT_LT(allowedAt(ofShaft, {0.0101, 0.0, -0.03}), 1e-5) << "outside of the hole";
}

TEST(FacePatches, AShaftIsCutAcrossItsFacets) {
  constexpr int kFacets = 96;
  const Body hole = test::checkBody("hole", test::holedPlate(kFacets, 0.01, 0.05, 0.0, 0.02));
  const Body shaft = test::checkBody("shaft", test::prism(kFacets, 0.0101, 0.4), {0.0, 0.0, -0.15});
  const AllowanceBound bound = boundOf(shaft, hole);
  ASSERT_TRUE(bound.mesh);
  EXPECT_LE(bound.mesh->triangles.size(), 28U * kFacets) << "six cuts with four triangles each, and the ends";
  EXPECT_NEAR(areaOf(*bound.mesh), areaOf(*shaft.mesh), 1e-12) << "the surface is the same";
  EXPECT_TRUE(inPlace({"fine", "fine", bound.mesh, Pose::identity()}).interior) << "no edge is open";
  const double angle = std::numbers::pi / kFacets;
  const Vector3 across(0.0101 * std::cos(angle) * std::cos(angle), 0.0101 * std::cos(angle) * std::sin(angle), 0.0);
  EXPECT_GT(allowedAt(bound, across + Vector3(0.0, 0.0, 0.01)), 9e-5);
  EXPECT_LT(allowedAt(bound, across + Vector3(0.0, 0.0, -0.005)), 2e-5) << "outside of the hole";
  EXPECT_LT(allowedAt(bound, across + Vector3(0.0, 0.0, 0.025)), 2e-5);
}

TEST(FacePatches, AShaftIsCutAtAllItsHolesAtOnce) {
  constexpr int kFacets = 96;
  TriangleMesh walls = test::holedPlate(kFacets, 0.01, 0.05, 0.0, 0.02);
  append(walls, test::holedPlate(kFacets, 0.01, 0.05, 0.1, 0.11));
  const Body holes = test::checkBody("holes", walls);
  const Body shaft = test::checkBody("shaft", test::prism(kFacets, 0.0101, 0.4, 0.01), {0.0, 0.0, -0.15});
  const AllowanceBound bound = boundOf(shaft, holes);
  ASSERT_TRUE(bound.mesh);
  EXPECT_LE(bound.mesh->triangles.size(), 52U * kFacets) << "twelve cuts with four triangles each, and the ends";
  EXPECT_NEAR(areaOf(*bound.mesh), areaOf(*shaft.mesh), 1e-12) << "the surface is the same";
  EXPECT_TRUE(inPlace({"fine", "fine", bound.mesh, Pose::identity()}).interior) << "no edge is open";
  for (const double height : {0.01, 0.105}) EXPECT_GT(allowedAt(bound, {0.0101, 0.0, height}), 9e-5);
  for (const double height : {-0.01, 0.05, 0.13}) EXPECT_LT(allowedAt(bound, {0.0101, 0.0, height}), 2e-5);
}

TEST(RoundFaces, ACylinderThatIsSmoothAndStatedIsOne) {
  constexpr std::uint32_t kFacets = 24;
  TriangleMesh mesh = test::prism(kFacets, 0.01, 0.04);
  const SurfaceFace end{SurfaceFace::Kind::Plane};
  SurfaceFace wall{SurfaceFace::Kind::Cylinder};
  wall.radius = 0.01;
  mesh.faces = {end, wall, wall};
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    mesh.faceOf.push_back(t % 4 >= 2 ? 0U : 1U + t / (2U * kFacets));  // two halves of the wall
  }
  const PlacedBody body = inPlace(test::checkBody("shaft", mesh));
  ASSERT_EQ(body.rounds.size(), 1U);
  EXPECT_TRUE(body.rounds.front().isShaft);
  EXPECT_NEAR(body.rounds.front().radius, 0.01, 1e-9);
  EXPECT_NEAR(body.rounds.front().high - body.rounds.front().low, 0.04, 1e-9);
}

}  // namespace
}  // namespace glissade::check
