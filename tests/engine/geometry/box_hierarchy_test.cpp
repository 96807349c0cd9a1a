#include "engine/geometry/box_hierarchy.h"

#include <gtest/gtest.h>

#include <set>

#include "engine/base/random_stream.h"

namespace glissade {
namespace {

Vector3 randomCorner(RandomStream& stream, double most) {
  return {stream.uniform(-most, most), stream.uniform(-most, most), stream.uniform(-most, most)};
}

std::vector<Box3> randomBoxes(RandomStream& stream, std::size_t count) {
  std::vector<Box3> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3 corner = randomCorner(stream, 1.0);
    boxes.emplace_back(corner, corner + randomCorner(stream, 0.1).cwiseAbs());
  }
  if (count > 3) boxes[1] = boxes[2];  // two equal boxes
  return boxes;
}

TEST(BoxHierarchy, VisitsWhatIsNearEachOnce) {
  RandomStream stream(1, "boxes");
  for (const std::size_t count : {0U, 1U, 4U, 5U, 300U}) {
    const BoxHierarchy hierarchy(randomBoxes(stream, count));
    for (int i = 0; i < 200; ++i) {
      const Box3 near = Box3(randomCorner(stream, 1.2)).merged(Box3(randomCorner(stream, 1.2)));
      const double distance = i % 4 == 0 ? 0.0 : stream.uniform(0.0, 0.5);
      std::multiset<std::uint32_t> expected;
      for (std::uint32_t k = 0; k < count; ++k) {
        if (hierarchy.boxes()[k].squaredExteriorDistance(near) <= distance * distance) expected.insert(k);
      }
      std::multiset<std::uint32_t> visited;
      hierarchy.visit(near, distance, [&](std::uint32_t k) {
        visited.insert(k);
        return true;
      });
      ASSERT_EQ(visited, expected);
    }
  }
}

TEST(BoxHierarchy, EndsTheVisitWhenToldTo) {
  RandomStream stream(2, "boxes");
  const BoxHierarchy hierarchy(randomBoxes(stream, 100));
  int visited = 0;
  hierarchy.visit(hierarchy.box(), 0.0, [&](std::uint32_t) { return ++visited < 3; });
  EXPECT_EQ(visited, 3);
}

TEST(BoxHierarchy, VisitsTheNearestFirstUpToTheDistanceThatIsReturned) {
  RandomStream stream(3, "boxes");
  const BoxHierarchy hierarchy(randomBoxes(stream, 200));
  for (int i = 0; i < 200; ++i) {
    const Box3 near(randomCorner(stream, 2.0));
    std::vector<std::pair<double, std::uint32_t>> expected;
    for (std::uint32_t k = 0; k < 200; ++k) {
      expected.emplace_back(hierarchy.boxes()[k].squaredExteriorDistance(near), k);
    }
    std::sort(expected.begin(), expected.end());
    std::vector<std::uint32_t> visited;
    hierarchy.visitNearestFirst(near, std::numeric_limits<double>::infinity(), [&](std::uint32_t k) {
      visited.push_back(k);
      return visited.size() < 20 ? std::numeric_limits<double>::infinity() : -0.0;
    });
    // After the twentieth box only boxes that contain the point are accepted.
    ASSERT_GE(visited.size(), 20U);
    for (std::size_t k = 0; k < visited.size(); ++k) {
      ASSERT_EQ(visited[k], expected[k].second);
      ASSERT_TRUE(k < 20 || expected[k].first == 0.0);
    }
  }
}

}  // namespace
}  // namespace glissade
