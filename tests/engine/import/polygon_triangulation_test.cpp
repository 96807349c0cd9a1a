#include "engine/import/formats/polygon_triangulation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "engine/base/random_stream.h"

namespace glissade {
namespace {

double areaOf(const std::vector<Vector3>& polygon) {
  double area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3& a = polygon[i];
    const Vector3& b = polygon[(i + 1) % polygon.size()];
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  return area;
}

double areaOf(const std::vector<Vector3>& polygon, const TriangleIndices& triangle) {
  return areaOf({polygon[triangle[0]], polygon[triangle[1]], polygon[triangle[2]]});
}

/// Expects, in the plane z = 0, that every triangle is counter-clockwise, and that together they have the polygon's
/// area.
void expectCovers(const std::vector<Vector3>& polygon) {
  const auto triangles = triangulatePolygon(polygon);
  ASSERT_TRUE(triangles.has_value());
  EXPECT_EQ(triangles->size(), polygon.size() - 2);
  double sum = 0.0;
  for (const TriangleIndices& triangle : *triangles) {
    EXPECT_GE(areaOf(polygon, triangle), -1e-12);
    sum += std::abs(areaOf(polygon, triangle));
  }
  EXPECT_NEAR(sum, areaOf(polygon), 1e-9);
}

TEST(PolygonTriangulation, CoversStarShapedPolygons) {
  RandomStream random(1, "polygons");
  for (int i = 0; i < 200; ++i) {
    std::vector<Vector3> polygon;
    const std::uint64_t corners = 3 + random.bits() % 30;
    for (std::uint64_t k = 0; k < corners; ++k) {
      const double angle = 2.0 * std::acos(-1.0) * static_cast<double>(k) / static_cast<double>(corners);
      const double radius = random.uniform(0.1, 1.0);
      polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
    expectCovers(polygon);
  }
}

TEST(PolygonTriangulation, CoversCombs) {
  std::vector<Vector3> comb{{0, -1, 0}, {20, -1, 0}};
  for (int i = 20; i > 0; --i) comb.emplace_back(i, i % 2 == 0 ? 0.0 : 5.0, 0.0);
  comb.emplace_back(0, 0, 0);
  expectCovers(comb);
}

/// A square with a square hole: the outline runs to the hole and back along the same line.
TEST(PolygonTriangulation, CoversAPolygonWithABridgeToItsHole) {
  expectCovers(
      {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {0, 0, 0}, {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}});
}

TEST(PolygonTriangulation, APolygonWithoutAreaKeepsItsEdges) {
  const std::vector<Vector3> line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
  const auto triangles = triangulatePolygon(line);
  ASSERT_TRUE(triangles.has_value());
  EXPECT_EQ(triangles->size(), 2U);
}

TEST(PolygonTriangulation, KeepsTheOrientationInSpace) {
  const std::vector<Vector3> dart{{0, 0, 0}, {0, 2, 1}, {0, 0.5, 1}, {0, -1, 2}};  // the corner at 2 is reflex
  const auto triangles = triangulatePolygon(dart);
  ASSERT_TRUE(triangles.has_value());
  Vector3 sum = Vector3::Zero();
  for (const auto& [a, b, c] : *triangles) sum += (dart[b] - dart[a]).cross(dart[c] - dart[a]);
  for (const auto& [a, b, c] : *triangles) EXPECT_GE((dart[b] - dart[a]).cross(dart[c] - dart[a]).dot(sum), 0.0);
}

}  // namespace
}  // namespace glissade
