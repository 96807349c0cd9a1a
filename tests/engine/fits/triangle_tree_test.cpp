#include "engine/geometry/triangle_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "engine/geometry/primitives.h"
#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

constexpr double kTreeRoom = 0.1;  ///< half width, metres

Vector3 randomPoint(RandomStream& random) { return randomPose(random, kTreeRoom).position; }

/// Distance by trying barycentric coordinates, with a finer grid about the best ones in each round.
double distanceByTrying(const Triangle& t, const Vector3& p) {
  double u = 1.0 / 3.0;
  double v = 1.0 / 3.0;
  const auto at = [&](double a, double b) { return Vector3(t[0] + a * (t[1] - t[0]) + b * (t[2] - t[0])); };
  double best = (at(u, v) - p).norm();
  for (double step = 0.5; step > 1e-9; step *= 0.7) {
    for (int tries = 0; tries < 40; ++tries) {
      const double before = best;
      for (const auto& [du, dv] :
           {std::pair{step, 0.0}, {-step, 0.0}, {0.0, step}, {0.0, -step}, {step, -step}, {-step, step}}) {
        const double a = std::clamp(u + du, 0.0, 1.0);
        const double b = std::clamp(v + dv, 0.0, 1.0 - a);
        if ((at(a, b) - p).norm() >= best) continue;
        best = (at(a, b) - p).norm();
        u = a;
        v = b;
      }
      if (best == before) break;
    }
  }
  return best;
}

TEST(NearestPoint, IsAsNearAsAnyPointThatTryingFinds) {
  RandomStream random(11, "triangles");
  for (int round = 0; round < 300; ++round) {
    const Triangle triangle{randomPoint(random), randomPoint(random), randomPoint(random)};
    const Vector3 p = randomPoint(random);
    EXPECT_NEAR((nearestPoint(triangle, p) - p).norm(), distanceByTrying(triangle, p), 1e-5);
  }
}

TEST(TriangleTree, AnswersAsAllTrianglesDo) {
  RandomStream random(3, "tree");
  const TriangleMesh mesh = makeSphere(0.05, 2);
  const TriangleTree tree(mesh);
  for (int round = 0; round < 200; ++round) {
    const Vector3 p = randomPoint(random);
    double least = std::numeric_limits<double>::infinity();
    for (const Triangle& triangle : tree.triangles()) least = std::min(least, (nearestPoint(triangle, p) - p).norm());
    const TriangleTree::Nearest found = tree.nearest(p, 1.0);
    EXPECT_DOUBLE_EQ(found.distance, least);
    EXPECT_DOUBLE_EQ((nearestPoint(tree.triangles()[found.triangle], p) - p).norm(), least);
    EXPECT_DOUBLE_EQ(tree.nearest(p, 0.5 * least).distance, 0.5 * least);
  }
}

TEST(TriangleTree, VisitsEveryPairThatIsNear) {
  RandomStream random(5, "pairs");
  const TriangleTree a(makeSphere(0.05, 1));
  for (int round = 0; round < 20; ++round) {
    const TriangleTree b(transformed(makeBox({0.05, 0.03, 0.08}), randomPose(random, kTreeRoom)));
    const double distance = 0.02 * random.uniform();
    std::set<std::pair<std::uint32_t, std::uint32_t>> visited;
    a.visitPairs(b, distance, [&](std::uint32_t i, std::uint32_t k) { return visited.insert({i, k}).second; });
    for (std::uint32_t i = 0; i < a.triangles().size(); ++i) {
      for (std::uint32_t k = 0; k < b.triangles().size(); ++k) {
        const Triangle& first = a.triangles()[i];
        const Triangle& second = b.triangles()[k];
        const bool near =
            trianglesMeet(first, second) || triangleDistance(first, second).squared <= distance * distance;
        EXPECT_TRUE(!near || visited.count({i, k}) > 0) << i << " " << k;
      }
    }
  }
}

}  // namespace
}  // namespace glissade
