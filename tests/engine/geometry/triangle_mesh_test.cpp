#include "engine/geometry/triangle_mesh.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

TEST(FaceNormal, IsOfLengthOneToTheOuterSideAndZWhereThereIsNoArea) {
  const TriangleMesh mesh{{{0, 0, 0}, {2, 0, 0}, {0, 0, -3}, {1, 0, 0}, {1e-30, 0, 0}, {0, 0, -1e-30}},
                          {{0, 1, 2}, {0, 2, 1}, {0, 3, 1}, {0, 0, 1}, {0, 4, 5}}};
  const std::vector<Vector3> expected{Vector3::UnitY(), -Vector3::UnitY(), Vector3::UnitZ(), Vector3::UnitZ(),
                                      Vector3::UnitY()};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_TRUE(faceNormal(mesh, mesh.triangles[i]).isApprox(expected[i], 1e-12)) << i;
  }
}

}  // namespace
}  // namespace glissade
