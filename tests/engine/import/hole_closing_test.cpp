#include "engine/import/hole_closing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/primitives.h"

namespace glissade {
namespace {

/// The mesh without the triangles whose corners all satisfy `there`.
template <class There>
TriangleMesh without(TriangleMesh mesh, There there) {
  std::erase_if(mesh.triangles, [&](const TriangleIndices& t) {
    return std::all_of(t.begin(), t.end(), [&](std::uint32_t corner) { return there(mesh.vertices[corner]); });
  });
  return mesh;
}

/// The walls of a pipe along z, without its rings.
TriangleMesh pipe(double inner, double outer, double length, bool withRings) {
  constexpr std::uint32_t kSides = 24;
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kSides;
    for (const double radius : {inner, outer}) {
      for (const double z : {0.0, length}) {
        mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
      }
    }
  }
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const std::uint32_t a = 4 * i;
    const std::uint32_t b = 4 * ((i + 1) % kSides);
    quad(a + 2, b + 2, b + 3, a + 3);  // outside
    quad(b, a, a + 1, b + 1);          // inside
    if (!withRings) continue;
    quad(a + 3, b + 3, b + 1, a + 1);
    quad(b + 2, a + 2, a, b);
  }
  return mesh;
}

TEST(HoleClosing, AClosedMeshStaysAsItIs) {
  const TriangleMesh box = welded(makeBox(Vector3(1, 2, 3)));
  const ClosedHoles result = withPlanarHolesClosed(box);
  EXPECT_EQ(result.closed + result.left, 0U);
  EXPECT_EQ(result.mesh.triangles, box.triangles);
}

TEST(HoleClosing, APlanarHoleIsClosedAndTheSolidIsWhatItWas) {
  const TriangleMesh whole = welded(makeCylinder(0.01, 0.05));
  const TriangleMesh open = without(whole, [](const Vector3& v) { return v.z() > 0.0249; });
  ASSERT_FALSE(audit(open).closed());
  const ClosedHoles result = withPlanarHolesClosed(open);
  EXPECT_EQ(result.closed, 1U);
  EXPECT_EQ(result.left, 0U);
  const MeshAudit closed = audit(result.mesh);
  EXPECT_TRUE(closed.closed());
  EXPECT_TRUE(closed.consistentlyOriented);
  EXPECT_NEAR(closed.volume, audit(whole).volume, 1e-12);
  EXPECT_EQ(result.mesh.vertices, open.vertices);
}

TEST(HoleClosing, AHoleThatIsNotPlanarIsLeft) {
  TriangleMesh bent = without(welded(makeBox(Vector3(1, 1, 1))), [](const Vector3& v) { return v.z() > 0.0; });
  for (Vector3& vertex : bent.vertices) {
    if (vertex.z() > 0.0 && vertex.x() * vertex.y() > 0.0) vertex.z() += 0.2;
  }
  const ClosedHoles result = withPlanarHolesClosed(bent);
  EXPECT_EQ(result.closed, 0U);
  EXPECT_EQ(result.left, 1U);
  EXPECT_EQ(result.mesh.triangles, bent.triangles);
}

/// A cover of each edge would close the bore.
TEST(HoleClosing, TheOpenEndOfAPipesWallIsLeft) {
  ASSERT_TRUE(audit(pipe(0.4, 0.5, 2.0, true)).closed());
  ASSERT_GT(audit(pipe(0.4, 0.5, 2.0, true)).volume, 0.0);
  const TriangleMesh open = pipe(0.4, 0.5, 2.0, false);
  const ClosedHoles result = withPlanarHolesClosed(open);
  EXPECT_EQ(result.closed, 0U);
  EXPECT_EQ(result.left, 4U);
  EXPECT_EQ(result.mesh.triangles, open.triangles);
}

TEST(HoleClosing, HolesThatMeetInAVertexAreLeft) {
  TriangleMesh sheet;
  sheet.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 3, 4}};
  const ClosedHoles result = withPlanarHolesClosed(sheet);
  EXPECT_EQ(result.closed, 0U);
  EXPECT_GE(result.left, 1U);
  EXPECT_EQ(result.mesh.triangles, sheet.triangles);
}

}  // namespace
}  // namespace glissade
