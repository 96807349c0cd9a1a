#include "engine/geometry/t_junctions.h"

#include <gtest/gtest.h>

#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/primitives.h"

namespace glissade {
namespace {

/// A box whose upper face is divided into quarters, at points that are `off` away from their edges.
TriangleMesh boxWithDividedTop(double off) {
  TriangleMesh box = makeBox(Vector3(2.0, 2.0, 2.0));
  TriangleMesh mesh;
  mesh.vertices = box.vertices;
  for (const TriangleIndices& triangle : box.triangles) {
    const bool top =
        std::all_of(triangle.begin(), triangle.end(), [&](std::uint32_t i) { return box.vertices[i].z() > 0.5; });
    if (!top) {
      mesh.triangles.push_back(triangle);
      continue;
    }
    std::array<std::uint32_t, 3> middles{};
    for (std::size_t i = 0; i < 3; ++i) {
      middles[i] = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back(0.5 * (box.vertices[triangle[i]] + box.vertices[triangle[(i + 1) % 3]]) +
                              Vector3(0.0, 0.0, off));
    }
    mesh.triangles.push_back({triangle[0], middles[0], middles[2]});
    mesh.triangles.push_back({middles[0], triangle[1], middles[1]});
    mesh.triangles.push_back({middles[2], middles[1], triangle[2]});
    mesh.triangles.push_back(middles);
  }
  return welded(mesh);
}

TEST(TJunctions, AreClosed) {
  for (const double off : {0.0, 1e-6}) {
    const TriangleMesh open = boxWithDividedTop(off);
    EXPECT_FALSE(audit(open).closed());
    const auto closed = closedAtTJunctions(open);
    ASSERT_TRUE(closed);
    const MeshAudit sound = audit(closed->mesh);
    EXPECT_TRUE(sound.closed());
    EXPECT_TRUE(sound.consistentlyOriented);
    EXPECT_NEAR(sound.volume, 8.0, 1e-5);
    EXPECT_EQ(closed->edges, 4U);
    EXPECT_NEAR(closed->moved, off, 1e-12);
  }
}

TEST(TJunctions, WhatTheyDoNotCloseIsLeft) {
  EXPECT_FALSE(closedAtTJunctions(welded(makeBox(Vector3(1.0, 1.0, 1.0)))));
  EXPECT_FALSE(closedAtTJunctions(boxWithDividedTop(1e-4)));
  TriangleMesh holed = boxWithDividedTop(0.0);
  holed.triangles.pop_back();
  EXPECT_FALSE(closedAtTJunctions(holed));
  EXPECT_FALSE(closedAtTJunctions(TriangleMesh()));
}

}  // namespace
}  // namespace glissade
