#include "engine/sweep/level_surface.h"

#include <gtest/gtest.h>

#include "engine/base/random_stream.h"
#include "engine/geometry/mesh_audit.h"

namespace glissade {
namespace {

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
    const MeshAudit report = audit(surface);
    EXPECT_TRUE(report.closed());
    EXPECT_TRUE(report.consistentlyOriented);
    EXPECT_GT(report.volume, 0.0);
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
