#include "engine/operator/haptic/god_object.h"

#include <gtest/gtest.h>

#include "engine/base/random_stream.h"
#include "engine/base/tolerances.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

class GodObjectInTheWindow : public testing::Test {
 protected:
  void follow(const Pose& X_WD, int cycles) {
    for (int i = 0; i < cycles; ++i) {
      if (object.needsSurroundings()) object.learn(lookAround(*query, object.pose(), 0.2));
      object.follow(X_WD);
    }
  }

  Problem problem = windowProblem();
  std::unique_ptr<CollisionQuery> query = problem.world->makeQuery();
  std::unique_ptr<CollisionQuery> judge = problem.world->withBackend(CollisionBackend::Fcl)->makeQuery();
  GodObject object{problem.world->objectRadius()};
};

TEST_F(GodObjectInTheWindow, FollowsFreelyWhereNothingIsInTheWay) {
  object.place(problem.start);
  const Pose q{{-1.2, 0.3, 0.2}, fromRollPitchYaw(0.3, 0.2, 0.1)};
  follow(q, 50);
  EXPECT_EQ(object.pose(), q);
}

TEST_F(GodObjectInTheWindow, KnowsNothingSoStays) {
  object.place(problem.start);
  object.follow(Pose());
  EXPECT_EQ(object.pose(), problem.start);
}

TEST_F(GodObjectInTheWindow, StopsAtTheWallAndSlidesAlongIt) {
  object.place(Pose::translation({-1.0, 1.0, 0.0}));
  follow(Pose::translation({0.5, 1.0, 0.0}), 500);
  const double gap = tolerance::kContactGap * problem.world->objectRadius();
  EXPECT_NEAR(object.pose().position.x(), -0.3 - gap, 0.5 * gap);
  EXPECT_NEAR(object.pose().position.y(), 1.0, 1e-3);
  follow(Pose::translation({0.0, 1.5, 0.7}), 12000);
  EXPECT_NEAR(object.pose().position.x(), -0.3 - gap, 0.5 * gap);
  EXPECT_NEAR(object.pose().position.y(), 1.5, 1e-2);
  EXPECT_NEAR(object.pose().position.z(), 0.7, 1e-2);
}

TEST_F(GodObjectInTheWindow, TurnsFlatOnTheWallWhenPressedAgainstIt) {
  object.place({{-1.0, 1.2, 0.0}, fromRollPitchYaw(0.0, 0.0, 0.2)});
  follow(Pose::translation({0.0, 1.2, 0.0}), 4000);
  EXPECT_LT(angleBetween(object.pose().orientation, Quaternion::Identity()), 0.02);
}

TEST_F(GodObjectInTheWindow, IsNeverInCollisionHoweverLateItsKnowledge) {
  RandomStream stream(1, "hand");
  for (const int lateness : {1, 7, 40}) {
    object.place(problem.start);
    Pose hand = problem.start;
    Surroundings pending = lookAround(*query, object.pose(), 0.2);
    for (int i = 0; i < 6000; ++i) {
      if (i % 400 == 0) hand = randomPose(stream, 1.2);
      if (i % lateness == 0) {
        object.learn(pending);
        pending = lookAround(*query, object.pose(), 0.2);
      }
      object.follow(hand);
      if (i % 10 != 0) continue;
      ASSERT_FALSE(judge->collides(object.pose())) << lateness << " " << i;
    }
  }
}

TEST_F(GodObjectInTheWindow, GoesWithTheHandWhenItWasPutIntoCollision) {
  object.place(Pose::translation({0.0, 1.5, 0.0}));
  follow(Pose::translation({-1.0, 1.5, 0.0}), 10);
  EXPECT_EQ(object.pose(), Pose::translation({-1.0, 1.5, 0.0}));
}

}  // namespace
}  // namespace glissade
