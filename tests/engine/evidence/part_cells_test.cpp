#include "engine/evidence/part_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "engine/geometry/nearest_point.h"

namespace glissade::evidence {
namespace {

/// Small triangles on a bent strip, and a part below it.
struct RandomSurface {
  explicit RandomSurface(unsigned seed) : random(seed) {
    for (int i = 0; i < 40; ++i) {
      const Vector3 at{number(-1.0, 1.0), number(-1.0, 1.0), 0.3 * number(-1.0, 1.0)};
      triangles.push_back({at, at + point(0.2), at + point(0.2)});
      const Triangle& t = triangles.back();
      normals.push_back((t[1] - t[0]).cross(t[2] - t[0]).normalized());
      near.push_back(static_cast<std::uint32_t>(i));
    }
    const double below = number(-0.6, -0.4);
    part = {Vector3(-1.0, -1.0, below), Vector3(1.0, -1.0, below), Vector3(0.0, 1.0, below)};
  }
  double number(double least, double most) { return std::uniform_real_distribution(least, most)(random); }
  Vector3 point(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  double distance(const Vector3& p, std::uint32_t t) const { return (nearestPoint(triangles[t], p) - p).norm(); }
  Vector3 pointIn(const Triangle& cell) {
    const double u = number(0.0, 1.0);
    const double v = number(0.0, 1.0 - u);
    return cell[0] + u * (cell[1] - cell[0]) + v * (cell[2] - cell[0]);
  }

  std::mt19937 random;
  std::vector<Triangle> triangles;
  std::vector<Vector3> normals;
  std::vector<std::uint32_t> near;
  Triangle part;
};

/// The oracle compares all triangles.
TEST(PartCells, KeepTheNearestTriangleOfEachOfTheirPoints) {
  int dropped = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    RandomSurface surface(seed);
    PartCells cells(surface.part, surface.triangles, surface.normals, surface.near);
    for (int i = 0; i < 60; ++i) {
      const PartCell cell = cells.take();
      dropped += static_cast<int>(surface.near.size() - cell.near.size());
      for (int k = 0; k < 20; ++k) {
        const Vector3 p = surface.pointIn(cell.corners);
        const auto isNearer = [&](std::uint32_t a, std::uint32_t b) {
          return surface.distance(p, a) < surface.distance(p, b);
        };
        const std::uint32_t nearest = *std::min_element(surface.near.begin(), surface.near.end(), isNearer);
        EXPECT_TRUE(std::binary_search(cell.near.begin(), cell.near.end(), nearest)) << "seed " << seed;
      }
      cells.halve(cell);
    }
  }
  EXPECT_GT(dropped, 20 * 60 * 20) << "more than half of the triangles are dropped";
}

/// A wave of facets, as the wall of a hole and a thread have it.
TEST(PartCells, NoPointIsFartherThanTheBound) {
  std::mt19937 random(5);
  for (const double height : {0.02, -0.02}) {
    std::vector<Triangle> triangles;
    std::vector<Vector3> normals;
    std::vector<std::uint32_t> near;
    const auto at = [&](int i, double y) { return Vector3(0.1 * i, y, i % 2 == 0 ? 0.0 : height); };
    for (int i = 0; i < 10; ++i) {
      for (const Triangle& t :
           {Triangle{at(i, 0.0), at(i + 1, 0.0), at(i + 1, 1.0)}, Triangle{at(i, 0.0), at(i + 1, 1.0), at(i, 1.0)}}) {
        near.push_back(static_cast<std::uint32_t>(triangles.size()));
        triangles.push_back(t);
        normals.push_back((t[1] - t[0]).cross(t[2] - t[0]).normalized());
      }
    }
    const Triangle part{Vector3(0.1, 0.1, -0.2), Vector3(0.9, 0.1, -0.2), Vector3(0.5, 0.9, -0.25)};
    PartCells cells(part, triangles, normals, near);
    for (int i = 0; i < 200; ++i) {
      const PartCell cell = cells.take();
      for (int k = 0; k < 20; ++k) {
        std::uniform_real_distribution<double> share(0.0, 1.0);
        const double u = share(random);
        const double v = (1.0 - u) * share(random);
        const Vector3 p =
            cell.corners[0] + u * (cell.corners[1] - cell.corners[0]) + v * (cell.corners[2] - cell.corners[0]);
        double least = 1.0;
        for (const Triangle& t : triangles) least = std::min(least, (nearestPoint(t, p) - p).norm());
        EXPECT_LE(least, cell.bound + 1e-12);
      }
      cells.halve(cell);
    }
  }
}

}  // namespace
}  // namespace glissade::evidence
