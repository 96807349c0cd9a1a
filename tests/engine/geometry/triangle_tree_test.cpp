#include "engine/geometry/triangle_tree.h"

#include <gtest/gtest.h>

#include <mutex>
#include <set>

#include "engine/base/random_stream.h"

namespace glissade {
namespace {

TriangleMesh randomTriangles(RandomStream& stream, std::uint32_t count) {
  constexpr double kSize = 0.05;
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vector3 at(stream.uniform(0, 1), stream.uniform(0, 1), stream.uniform(0, 1));
    for (int corner = 0; corner < 3; ++corner) {
      mesh.vertices.push_back(at + kSize * Vector3(stream.uniform(0, 1), stream.uniform(0, 1), stream.uniform(0, 1)));
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

TEST(TriangleTree, SeveralThreadsVisitThePairsThatOneVisits) {
  RandomStream stream(1, "pairs");
  const TriangleTree many(randomTriangles(stream, 6000));
  const TriangleTree few(randomTriangles(stream, 300));
  using Pairs = std::multiset<std::pair<std::uint32_t, std::uint32_t>>;
  for (const auto& [one, other] : {std::pair(&many, &few), std::pair(&few, &many), std::pair(&many, &many)}) {
    Pairs expected;
    one->visitPairs(*other, 0.001, [&expected](std::uint32_t i, std::uint32_t k) {
      expected.insert({i, k});
      return true;
    });
    Pairs found;
    std::mutex mutex;
    one->visitAllPairs(*other, 0.001, [&](std::uint32_t i, std::uint32_t k) {
      const std::lock_guard lock(mutex);
      found.insert({i, k});
    });
    EXPECT_GT(expected.size(), 200U);
    EXPECT_EQ(found, expected);
  }
}

/// The oracle samples the segment.
TEST(TriangleTree, DistanceToASegmentIsThatOfItsNearestPoint) {
  RandomStream stream(2, "segments");
  const TriangleTree tree(randomTriangles(stream, 6000));
  const auto point = [&stream] { return Vector3(stream.uniform(0, 1), stream.uniform(0, 1), stream.uniform(0, 1)); };
  int crossings = 0;
  for (int i = 0; i < 200; ++i) {
    const Vector3 a = point();
    const Vector3 b = a + stream.uniform(0.0, 0.3) * (point() - a);
    constexpr int kSamples = 200;
    double sampled = 10.0;
    for (int k = 0; k <= kSamples; ++k) {
      sampled = std::min(sampled, tree.nearest(a + (b - a) * k / kSamples, 10.0).distance);
    }
    const double found = tree.distanceToSegment(a, b, 10.0);
    EXPECT_LE(found, sampled + 1e-12);
    EXPECT_GE(found, sampled - (b - a).norm() / kSamples);
    EXPECT_EQ(tree.distanceToSegment(a, b, 0.5 * found), 0.5 * found);
    crossings += found < 1e-9 ? 1 : 0;
  }
  EXPECT_GT(crossings, 5);
}

}  // namespace
}  // namespace glissade
