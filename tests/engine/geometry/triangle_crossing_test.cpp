#include "engine/geometry/triangle_crossing.h"

#include <gtest/gtest.h>

#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

const Triangle kFloor{Vector3(-1.0, -1.0, 0.0), Vector3(3.0, -1.0, 0.0), Vector3(-1.0, 3.0, 0.0)};

/// An upright triangle over the floor, with its lower edge at this height.
Triangle uprightAt(double height) {
  return {Vector3(0.0, 0.0, height), Vector3(1.0, 0.0, height), Vector3(0.5, 0.1, height + 1.0)};
}

TEST(TriangleCrossing, TouchingAndSharedPlanesAreNoCrossing) {
  EXPECT_FALSE(trianglesCross(uprightAt(0.0), kFloor, 1e-9));
  EXPECT_FALSE(trianglesCross(kFloor, kFloor, 1e-9));
  EXPECT_FALSE(trianglesCross(uprightAt(-1.0), kFloor, 1e-9));
  EXPECT_TRUE(trianglesCross(uprightAt(-0.5), kFloor, 1e-9));
  EXPECT_FALSE(trianglesCross(uprightAt(-1e-4), kFloor, 1e-3)) << "by less than what is asked";
  EXPECT_TRUE(trianglesCross(uprightAt(-1e-2), kFloor, 1e-3));
}

TEST(TriangleCrossing, IsAMeetingThatIsNoTouch) {
  RandomStream random(1, "triangles");
  const auto point = [&] { return Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)); };
  int crossings = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Triangle a{point(), point(), point()};
    const Triangle b{point(), point(), point()};
    const bool cross = trianglesCross(a, b, 0.0);
    EXPECT_EQ(cross, trianglesMeet(a, b));
    EXPECT_EQ(cross, trianglesCross(b, a, 0.0));
    crossings += cross ? 1 : 0;
  }
  EXPECT_GT(crossings, 1000);
}

}  // namespace
}  // namespace glissade
