#include "engine/check/thread_axis.h"

#include <gtest/gtest.h>

#include "tests/engine/check/check_bodies.h"

namespace glissade::check {
namespace {

PlacedBody placedAt(const Body& body, const Pose& X_WB) { return PlacedBody(body, X_WB * body.X_WB); }

struct Pair {
  Pose tilt{Vector3(0.1, -0.2, 0.05), fromRollPitchYaw(0.3, -0.6, 1.1)};
  PlacedBody bolt = placedAt(test::checkBody("bolt", test::prism(40, 0.005, 0.03)), tilt);
  PlacedBody nut = placedAt(test::checkBody("nut", test::holedPlate(48, 0.0046, 0.009, 0.01, 0.02)), tilt);
};

TEST(ThreadAxis, IsFoundFromTheMeshes) {
  const Pair pair;
  const auto found = threadAxis(pair.nut, pair.bolt, std::nullopt);
  ASSERT_TRUE(found.ok()) << toString(found.error().reason);
  EXPECT_NEAR(found->radiusMoving, 0.0046, 1e-8);
  EXPECT_NEAR(found->radiusOther, 0.005, 1e-8);
  EXPECT_FALSE(found->movingIsShaft);
  const Vector3 axis = pair.tilt.orientation * Vector3::UnitZ();
  EXPECT_LT(found->axis.cross(axis).norm(), 1e-6);
  EXPECT_LT((found->point - pair.tilt.position).cross(axis).norm(), 1e-8);
}

TEST(ThreadAxis, OfAFileIsTakenOnlyWhereTheMeshesShowIt) {
  const Pair pair;
  StatedThread stated{pair.tilt.position, pair.tilt.orientation * Vector3::UnitZ(), 0.0015, 0.0046, 0.005};
  EXPECT_TRUE(threadAxis(pair.nut, pair.bolt, stated).ok());
  StatedThread moved = stated;
  moved.point += pair.tilt.orientation * Vector3(1e-4, 0.0, 0.0);
  EXPECT_FALSE(threadAxis(pair.nut, pair.bolt, moved).ok());
  StatedThread tilted = stated;
  tilted.direction = pair.tilt.orientation * Vector3(0.05, 0.0, 1.0);
  EXPECT_FALSE(threadAxis(pair.nut, pair.bolt, tilted).ok());
  StatedThread wide = stated;
  wide.radiusMoving = 0.0049;
  EXPECT_FALSE(threadAxis(pair.nut, pair.bolt, wide).ok());
}

TEST(ThreadAxis, BodiesBesideEachOtherHaveNone) {
  const Pair pair;
  const PlacedBody aside = placedAt(test::checkBody("nut", test::holedPlate(48, 0.0046, 0.009, 0.04, 0.05)), pair.tilt);
  EXPECT_FALSE(threadAxis(aside, pair.bolt, std::nullopt).ok()) << "beyond the end of the bolt";
}

TEST(ThreadAxis, APitchHasLimits) {
  Thread thread;
  thread.radiusMoving = thread.radiusOther = 0.005;
  for (const double pitch : {0.0015, -0.0015, 0.02, 1e-5}) {
    thread.pitch = pitch;
    EXPECT_TRUE(wrongPitch(thread).empty()) << pitch;
  }
  for (const double pitch : {1e6, 0.021, 0.0, -9e-6}) {
    thread.pitch = pitch;
    EXPECT_FALSE(wrongPitch(thread).empty()) << pitch;
  }
}

}  // namespace
}  // namespace glissade::check
