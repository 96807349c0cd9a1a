#include "engine/geometry/intersection_curve.h"

#include <gtest/gtest.h>

#include "engine/geometry/primitives.h"
#include "engine/geometry/triangle_tree.h"
#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

TEST(IntersectionCurve, EveryPointLiesOnBothSurfaces) {
  RandomStream random(3, "intersection curve");
  const TriangleMesh box = makeBox({0.4, 0.3, 0.2});
  const TriangleMesh other = makeBox({0.3, 0.5, 0.1});
  int curves = 0;
  for (int round = 0; round < 60; ++round) {
    const Pose X_WA = randomPose(random, 0.15);
    const Pose X_WB = randomPose(random, 0.15);
    const auto ends = intersectionCurve(box, X_WA, other, X_WB, 10'000);
    const TriangleTree treeA(transformed(box, X_WA));
    const TriangleTree treeB(transformed(other, X_WB));
    bool meet = false;
    for (const Triangle& a : treeA.triangles()) {
      for (const Triangle& b : treeB.triangles()) meet = meet || trianglesMeet(a, b);
    }
    EXPECT_EQ(!ends.empty(), meet) << "round " << round;
    ASSERT_EQ(ends.size() % 2, 0U);
    for (const Vector3& p : ends) {
      EXPECT_LT(treeA.nearest(p, 1.0).distance, 1e-9);
      EXPECT_LT(treeB.nearest(p, 1.0).distance, 1e-9);
    }
    curves += ends.empty() ? 0 : 1;
  }
  EXPECT_GT(curves, 20);
}

TEST(IntersectionCurve, HasNoMoreSegmentsThanAskedFor) {
  const TriangleMesh ball = makeSphere(0.5);
  const auto ends = intersectionCurve(ball, Pose::identity(), ball, Pose::translation({0.3, 0.0, 0.0}), 7);
  EXPECT_EQ(ends.size(), 14U);
}

}  // namespace
}  // namespace glissade
