#include "engine/access/sight.h"

#include <gtest/gtest.h>

#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

TEST(Sight, APlateBetweenTheEyeAndThePlaceHidesIt) {
  const TriangleMesh place = makeBox({0.02, 0.02, 0.02});
  const std::vector<RigidBody> bodies{boxBody("plate", {0.2, 0.2, 0.01}, Pose::translation({0.0, 0.0, 0.1}))};
  Sight sight(bodies);
  const SightAnswer above = sight.of(place, {{0.0, 0.0, 0.5}}, {0});
  EXPECT_FALSE(above.isSeen());
  EXPECT_EQ(above.share, 0.0);
  EXPECT_EQ(above.blockedBy, std::optional<std::size_t>(0));
  EXPECT_EQ(sight.of(place, {{0.0, 0.0, -0.5}}, {0}).share, 1.0) << "from the other side";
  EXPECT_EQ(sight.of(place, {{0.0, 0.0, 0.5}}, {}).share, 1.0) << "while the plate is not there";
}

TEST(Sight, TheBestEyeCounts) {
  const TriangleMesh place = makeBox({0.02, 0.02, 0.02});
  const std::vector<RigidBody> bodies{boxBody("lid", {0.1, 0.1, 0.01}, Pose::translation({0.0, 0.0, 0.02}))};
  Sight sight(bodies);
  const SightAnswer best = sight.of(place, eyesAbout(boundingBox(place), Vector3::UnitZ()), {0});
  EXPECT_TRUE(best.isSeen());
  EXPECT_LT(best.eye.z(), 0.4) << "not from above";
}

TEST(Sight, NothingIsSeenInAClosedBox) {
  const TriangleMesh place = makeBox({0.02, 0.02, 0.02});
  std::vector<RigidBody> walls;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Vector3 size = Vector3::Constant(0.12);
      size[axis] = 0.01;
      Vector3 at = Vector3::Zero();
      at[axis] = side * 0.055;
      walls.push_back(boxBody("wall", size, Pose::translation(at)));
    }
  }
  Sight sight(walls);
  EXPECT_EQ(sight.of(place, eyesAbout(boundingBox(place), Vector3::UnitZ()), {0, 1, 2, 3, 4, 5}).share, 0.0);
}

}  // namespace
}  // namespace glissade
