#include "engine/geometry/separate_solids.h"

#include <gtest/gtest.h>

#include "engine/geometry/primitives.h"

namespace glissade {
namespace {

TriangleMesh boxes(const std::vector<Vector3>& middles) {
  TriangleMesh mesh;
  for (const Vector3& at : middles) append(mesh, transformed(makeBox({1.0, 1.0, 1.0}), Pose::translation(at)));
  return mesh;
}

TEST(SeparateSolids, AreThoseThatTouchNoOther) {
  EXPECT_EQ(separateSolids(boxes({{0.0, 0.0, 0.0}}), 1e-5), 1U);
  EXPECT_EQ(separateSolids(boxes({{0.0, 0.0, 0.0}, {1.2, 0.0, 0.0}}), 1e-5), 2U);
  EXPECT_EQ(separateSolids(boxes({{0.0, 0.0, 0.0}, {1.0, 0.3, 0.3}}), 1e-5), 1U) << "face on face";
  EXPECT_EQ(separateSolids(boxes({{0.0, 0.0, 0.0}, {1.0, 0.3, 0.3}, {5.0, 0.0, 0.0}}), 1e-5), 2U);
}

TEST(SeparateSolids, AHollowIsNoSolid) {
  TriangleMesh hollow = boxes({{0.0, 0.0, 0.0}});
  TriangleMesh inside = makeBox({0.5, 0.5, 0.5});
  for (TriangleIndices& triangle : inside.triangles) std::swap(triangle[0], triangle[1]);
  append(hollow, inside);
  EXPECT_EQ(separateSolids(hollow, 1e-5), 1U);
}

}  // namespace
}  // namespace glissade
