#include "engine/geometry/triangle_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/random_stream.h"
#include "engine/geometry/primitives.h"
#include "tests/engine/support/mesh_triangles.h"

namespace glissade {
namespace {

Vector3 randomVector(RandomStream& stream) {
  const double x = stream.normal();
  const double y = stream.normal();
  return {x, y, stream.normal()};
}

TEST(RaysOfATriangleTree, FindsTheWallsOfABoxFromInside) {
  const TriangleTree tree(trianglesOf(makeBox({2.0, 4.0, 6.0})));
  EXPECT_NEAR(tree.firstHit({0.1, 0.2, 0.3}, Vector3::UnitX(), 0.0), 0.9, 1e-12);
  EXPECT_NEAR(tree.firstHit({0.1, 0.2, 0.3}, -Vector3::UnitY(), 0.0), 2.2, 1e-12);
  EXPECT_NEAR(tree.firstHit({0.1, 0.2, -9.0}, Vector3::UnitZ(), 0.0), 6.0, 1e-12);
}

TEST(RaysOfATriangleTree, FindsOnlyHitsBeyondTheGivenOne) {
  const TriangleTree tree(trianglesOf(makeBox({2.0, 2.0, 2.0})));
  EXPECT_NEAR(tree.firstHit({0.1, 0.2, -3.0}, Vector3::UnitZ(), 2.5), 4.0, 1e-12);
  EXPECT_TRUE(std::isinf(tree.firstHit({0.1, 0.2, -3.0}, Vector3::UnitZ(), 4.5)));
  EXPECT_TRUE(std::isinf(tree.firstHit({0.1, 0.2, 3.0}, Vector3::UnitZ(), 0.0)));
  EXPECT_TRUE(std::isinf(TriangleTree(std::vector<Triangle>{}).firstHit(Vector3::Zero(), Vector3::UnitZ(), 0.0)));
}

TEST(RaysOfATriangleTree, FindsWhatALookAtEveryTriangleFinds) {
  RandomStream stream(7, "rays");
  std::vector<Triangle> triangles;
  for (int i = 0; i < 300; ++i) {
    const Vector3 at = 3.0 * randomVector(stream);
    triangles.push_back({at, at + randomVector(stream), at + randomVector(stream)});
  }
  const TriangleTree tree(triangles);
  int hits = 0;
  for (int ray = 0; ray < 2000; ++ray) {
    const Vector3 origin = 4.0 * randomVector(stream);
    const Vector3 direction = randomVector(stream).normalized();
    double least = std::numeric_limits<double>::infinity();
    for (const Triangle& triangle : triangles)
      least = std::min(least, TriangleTree(std::vector<Triangle>{triangle}).firstHit(origin, direction, 0.0));
    EXPECT_EQ(tree.firstHit(origin, direction, 0.0), least) << "ray " << ray;
    hits += std::isfinite(least) ? 1 : 0;
  }
  EXPECT_GT(hits, 200);
}

}  // namespace
}  // namespace glissade
