#include "engine/sweep/level_surface.h"

#include <gtest/gtest.h>

#include <map>

#include "engine/base/random_stream.h"

namespace glissade {
namespace {

/// How often each directed edge occurs: in a closed surface as often as its reverse.
bool isClosed(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const TriangleIndices& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = triangle[i];
      const std::uint32_t to = triangle[(i + 1) % 3];
      edges[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  }
  return std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
}

TEST(LevelSurface, OfRandomValuesIsClosedAndHasTheSmallerValuesInside) {
  RandomStream random(7, "level surface");
  const Lattice lattice{{1.0, 2.0, 3.0}, 0.5, {9, 8, 7}};
  for (int round = 0; round < 20; ++round) {
    std::vector<float> values(lattice.size(), 1.0F);
    for (int x = 1; x < 8; ++x) {
      for (int y = 1; y < 7; ++y) {
        for (int z = 1; z < 6; ++z) values[lattice.at(x, y, z)] = static_cast<float>(random.uniform(0.0, 1.0));
      }
    }
    const TriangleMesh surface = levelSurface(lattice, values, 0.4F);
    ASSERT_FALSE(surface.empty());
    EXPECT_TRUE(isClosed(surface));
    double volume = 0.0;
    for (const auto& [a, b, c] : surface.triangles) {
      volume += surface.vertices[a].dot(surface.vertices[b].cross(surface.vertices[c])) / 6.0;
    }
    EXPECT_GT(volume, 0.0);
  }
}

TEST(LevelSurface, OfALinearFunctionIsExact) {
  const Lattice lattice{Vector3::Zero(), 0.1, {12, 12, 12}};
  std::vector<float> values(lattice.size(), 2.0F);
  const Vector3 normal = Vector3(1.0, 2.0, -1.0).normalized();
  for (int x = 1; x < 11; ++x) {
    for (int y = 1; y < 11; ++y) {
      for (int z = 1; z < 11; ++z) {
        values[lattice.at(x, y, z)] = static_cast<float>(normal.dot(lattice.point(x, y, z)));
      }
    }
  }
  int within = 0;
  for (const Vector3& vertex : levelSurface(lattice, values, 0.5F).vertices) {
    if (vertex.minCoeff() <= 0.1 || vertex.maxCoeff() >= 1.0) continue;  // at the rim
    EXPECT_NEAR(normal.dot(vertex), 0.5, 1e-6);
    ++within;
  }
  EXPECT_GT(within, 50);
}

}  // namespace
}  // namespace glissade
