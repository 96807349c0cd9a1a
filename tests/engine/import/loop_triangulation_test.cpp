#include "engine/import/loop_triangulation.h"

#include <cmath>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/import/plane_mesh.h"

namespace glissade {
namespace {

double coveredArea(const std::vector<PlanePoint>& points, const std::vector<TriangleIndices>& triangles) {
  double area = 0.0;
  for (const auto& [a, b, c] : triangles) area += 0.5 * doubleArea(points[a], points[b], points[c]);
  return area;
}

/// Expects that each side of a loop is the side of one triangle, and that all others have a triangle on either side.
void expectBoundary(const std::vector<PlaneLoop>& loops, const std::vector<TriangleIndices>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const TriangleIndices& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      ++sides[{t[i], t[(i + 1) % 3]}];
      --sides[{t[(i + 1) % 3], t[i]}];
    }
  }
  for (const PlaneLoop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      --sides[{loop[i], loop[(i + 1) % loop.size()]}];
      ++sides[{loop[(i + 1) % loop.size()], loop[i]}];
    }
  }
  for (const auto& [side, count] : sides) EXPECT_EQ(count, 0) << side.first << " " << side.second;
}

/// Adds a circle, counter-clockwise if `turn` is 1, clockwise if it is -1.
PlaneLoop addCircle(const PlanePoint& middle, double radius, int turn, std::vector<PlanePoint>& points) {
  constexpr int kParts = 40;
  PlaneLoop loop;
  for (int i = 0; i < kParts; ++i) {
    const double angle = turn * 2.0 * std::numbers::pi * i / kParts;
    loop.push_back(static_cast<std::uint32_t>(points.size()));
    points.emplace_back(middle + radius * PlanePoint(std::cos(angle), std::sin(angle)));
  }
  return loop;
}

double circleArea(double radius) { return 20.0 * radius * radius * std::sin(2.0 * std::numbers::pi / 40.0); }

TEST(LoopTriangulation, CoversADiscWithHolesOnce) {
  std::vector<PlanePoint> points;
  std::vector<PlaneLoop> loops{addCircle({0, 0}, 10, 1, points)};
  double expected = circleArea(10);
  for (const PlanePoint& middle : {PlanePoint(5, 0), PlanePoint(-5, 0), PlanePoint(0, 5), PlanePoint(1, -6)}) {
    loops.push_back(addCircle(middle, 2, -1, points));
    expected -= circleArea(2);
  }
  const auto found = triangulateLoops(points, loops);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->forced, 0U);
  EXPECT_NEAR(coveredArea(points, found->triangles), expected, 1e-9);
  expectBoundary(loops, found->triangles);

  PlaneMesh mesh(points, found->triangles);
  mesh.makeDelaunay();
  EXPECT_NEAR(coveredArea(mesh.points(), mesh.triangles()), expected, 1e-9);
  expectBoundary(loops, mesh.triangles());
  for (std::size_t t = 0; t < 100; ++t) mesh.split(t);
  EXPECT_GT(mesh.points().size(), points.size());
  EXPECT_NEAR(coveredArea(mesh.points(), mesh.triangles()), expected, 1e-9);
  expectBoundary(loops, mesh.triangles());
  for (const auto& [a, b, c] : mesh.triangles()) {
    EXPECT_GT(doubleArea(mesh.points()[a], mesh.points()[b], mesh.points()[c]), 0.0);
  }
}

TEST(LoopTriangulation, LoopsThatCrossKeepTheirSides) {
  std::vector<PlanePoint> points;
  std::vector<PlaneLoop> loops{addCircle({0, 0}, 10, 1, points)};
  loops.push_back(addCircle({8.01, 0}, 2, -1, points));
  const auto found = triangulateLoops(points, loops);
  ASSERT_TRUE(found);
  EXPECT_GT(found->forced, 0U);
  EXPECT_NEAR(coveredArea(points, found->triangles), circleArea(10) - circleArea(2), 1e-9);
  expectBoundary(loops, found->triangles);
}

TEST(LoopTriangulation, RefusesWhatIsNoRegion) {
  std::vector<PlanePoint> points;
  const PlaneLoop clockwise = addCircle({0, 0}, 10, -1, points);
  EXPECT_FALSE(triangulateLoops(points, {clockwise}));
  EXPECT_FALSE(triangulateLoops(points, {}));
  EXPECT_FALSE(triangulateLoops(points, {{0, 1}}));
}

}  // namespace
}  // namespace glissade
