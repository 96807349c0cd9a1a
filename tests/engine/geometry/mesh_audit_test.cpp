#include "engine/geometry/mesh_audit.h"

#include <gtest/gtest.h>

#include "engine/base/random_stream.h"
#include "engine/geometry/primitives.h"

namespace glissade {
namespace {

TEST(MeshAudit, SeesAHole) {
  TriangleMesh box = makeBox(Vector3::Ones());
  box.triangles.pop_back();
  EXPECT_FALSE(audit(box).closed());
  EXPECT_EQ(audit(box).openEdges, 3U);
}

TEST(MeshAudit, SeesAFlippedTriangle) {
  TriangleMesh box = makeBox(Vector3::Ones());
  std::swap(box.triangles[0][0], box.triangles[0][1]);
  EXPECT_TRUE(audit(box).closed());
  EXPECT_FALSE(audit(box).consistentlyOriented);
}

TEST(MeshAudit, ClosedSurfacesAreKnownWithoutAnAudit) {
  const TriangleMesh box = makeBox(Vector3::Ones());
  TriangleMesh open = box;
  open.triangles.pop_back();
  TriangleMesh withPoint = box;
  withPoint.triangles.push_back({0, 0, 1});
  TriangleMesh soup;
  for (const auto& [a, b, c] : box.triangles) {
    append(soup, {{box.vertices[a], box.vertices[b], box.vertices[c]}, {{0, 1, 2}}});
  }
  TriangleMesh touching = box;
  append(touching, transformed(box, Pose::translation({1, 0, 0})));
  TriangleMesh flipped = box;
  std::swap(flipped.triangles[0][0], flipped.triangles[0][1]);
  for (const TriangleMesh& mesh : {box, open, withPoint, soup, touching, flipped, TriangleMesh()}) {
    EXPECT_EQ(isClosedSurface(mesh), audit(mesh).closed()) << mesh.triangles.size() << " triangles";
  }
}

TEST(MeshAudit, CountsComponentsAndDegenerateTriangles) {
  TriangleMesh two = makeBox(Vector3::Ones());
  append(two, transformed(makeBox(Vector3::Ones()), Pose::translation({5, 0, 0})));
  two.triangles.push_back({0, 0, 1});
  const MeshAudit result = audit(two);
  EXPECT_EQ(result.surfaces.size(), 2U);
  EXPECT_EQ(result.degenerateTriangles, 1U);
}

TEST(MeshAudit, SurfacesAreListedInTheOrderOfTheirFirstTriangles) {
  TriangleMesh many;
  for (int i = 0; i < 2000; ++i) {
    append(many, transformed(makeBox(Vector3::Constant(0.5)), Pose::translation({double(i), 0, 0})));
  }
  const MeshAudit result = audit(many);
  EXPECT_TRUE(result.closed());
  ASSERT_EQ(result.surfaces.size(), 2000U);
  for (std::size_t i = 0; i < result.surfaces.size(); ++i) {
    const ConnectedSurface& surface = result.surfaces[i];
    ASSERT_NEAR((surface.box.center() - Vector3(double(i), 0, 0)).norm(), 0.0, 1e-12);
    ASSERT_NEAR((surface.box.sizes() - Vector3::Constant(0.5)).norm(), 0.0, 1e-12);
    ASSERT_NEAR((surface.point - surface.box.center()).cwiseAbs().minCoeff(), 0.25, 1e-12);
  }
}

TEST(MeshAudit, SplitVerticesCountAsOne) {
  // Importers deliver triangles with their own corners.
  const TriangleMesh box = makeBox(Vector3::Ones());
  TriangleMesh soup;
  for (const auto& triangle : box.triangles) {
    const auto base = static_cast<std::uint32_t>(soup.vertices.size());
    for (const auto vertex : triangle) soup.vertices.push_back(box.vertices[vertex]);
    soup.triangles.push_back({base, base + 1, base + 2});
  }
  EXPECT_TRUE(audit(soup).closed());
  EXPECT_EQ(audit(soup).surfaces.size(), 1U);
  EXPECT_EQ(welded(soup).vertices.size(), 8U);
  for (Vector3& vertex : soup.vertices) vertex.z() += 0.5;
  soup.vertices.front().z() = soup.vertices.front().z() == 0.0 ? -0.0 : soup.vertices.front().z();
  EXPECT_EQ(welded(soup).vertices.size(), 8U);  // zero has two signs
}

TEST(Containment, AgreesWithABoxOnRandomPointsWhateverTheOrientation) {
  TriangleMesh box = makeBox({2, 3, 4});
  TriangleMesh insideOut = scaled(box, {-1, 1, 1});
  for (auto& triangle : insideOut.triangles) std::swap(triangle[1], triangle[2]);
  RandomStream stream(9, "containment");
  for (int i = 0; i < 2000; ++i) {
    const Vector3 p(stream.uniform(-3, 3), stream.uniform(-3, 3), stream.uniform(-3, 3));
    const bool inside = std::abs(p.x()) < 1 && std::abs(p.y()) < 1.5 && std::abs(p.z()) < 2;
    EXPECT_EQ(containsPoint(box, p), inside);
    EXPECT_EQ(containsPoint(insideOut, p), inside);
  }
}

TEST(Containment, ACavityIsOutside) {
  TriangleMesh shell = makeBox({4, 4, 4});
  TriangleMesh cavity = makeBox({2, 2, 2});
  for (auto& triangle : cavity.triangles) std::swap(triangle[1], triangle[2]);
  append(shell, cavity);
  EXPECT_FALSE(containsPoint(shell, Vector3::Zero()));
  EXPECT_TRUE(containsPoint(shell, {1.5, 0, 0}));
}

}  // namespace
}  // namespace glissade
