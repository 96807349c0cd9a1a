// Tests the object in a hand with a tracked controller, alone and among obstacles. FCL judges.
#include "engine/operator/controllers/grasping_hand.h"

#include <gtest/gtest.h>

#include "engine/operator/device_registry.h"
#include "engine/operator/sliding_hand.h"
#include "tests/engine/operator/operator_support.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

constexpr double kTick = 0.008;
constexpr double kExact = 1e-9;

/// The object is a cube of 0.4 m; the wall is at x = -0.3 for its reference point.
class Grasp : public testing::Test {
 protected:
  std::unique_ptr<OperatorDevice> make(const char* id) const {
    DeviceContext context;
    context.hand = inputs;
    context.world = problem.world;
    return makeDeviceRegistry().find(id)->make(context);
  }
  void use(const char* id) { device = make(id); }

  ControllerInput& controller() { return inputs->rightController; }
  /// Sets the controller to a pose, with this squeeze, aiming along its own -z.
  void hold(const Pose& X_WG, double squeeze) {
    at = X_WG;
    squeezed = squeeze;
    controller().place.set({X_WG, X_WG, squeeze, 1.0});
  }
  void squeeze(double share) { hold(at, share); }
  void loseTracking() { controller().place.set({std::nullopt, std::nullopt, squeezed, 1.0}); }
  void advance(int ticks = 1) {
    for (int i = 0; i < ticks; ++i) q = device->advance(kTick, viewOf(q), kRoom);
  }
  /// Moves the controller, and gives the object time to follow.
  void move(const Pose& to) {
    hold(to, squeezed);
    advance(400);
  }
  /// Takes the cube at the middle of its side towards +y.
  void takeByHand() {
    hold(Pose::translation(q.position + Vector3(0.0, 0.25, 0.0)), 0.0);
    advance();
    squeeze(1.0);
    advance();
  }
  static void expectNear(const Pose& a, const Pose& b) {
    EXPECT_LT((a.position - b.position).norm(), kExact);
    EXPECT_LT(angleBetween(a.orientation, b.orientation), 1e-6);
  }

  Problem problem = windowProblem();
  double radius = problem.world->objectRadius();
  std::unique_ptr<CollisionQuery> judge = problem.world->withBackend(CollisionBackend::Fcl)->makeQuery();
  HandInputsPtr inputs = std::make_shared<HandInputs>(std::nullopt);
  std::unique_ptr<OperatorDevice> device = make("right-controller");
  Pose q = Pose::translation({-1.2, 0.0, 0.0});
  Pose at;
  double squeezed = 0.0;
};

TEST_F(Grasp, TakenWithoutAJumpItGoesWithTheControllerAndStaysWhereItIsLetGo) {
  const Pose before = q;
  takeByHand();
  EXPECT_EQ(q, before);
  EXPECT_TRUE(device->holds());
  const Pose grip = at;
  const Pose turned{Vector3(-1.3, 0.3, 0.1), Quaternion(Eigen::AngleAxisd(0.2, Vector3::UnitZ()))};
  move(turned);
  expectNear(q, turned * inverse(grip) * before);
  squeeze(0.0);
  advance();
  const Pose left = q;
  EXPECT_FALSE(device->holds());
  hold(Pose::translation({1.0, 1.0, 1.0}), 0.0);
  advance(100);
  EXPECT_EQ(q, left);
}

TEST_F(Grasp, AHandThatIsTooFarAwayAndPointsElsewhereTakesNothing) {
  const Pose before = q;
  hold(Pose::translation(q.position + Vector3(0.0, 0.2 + 1.1 * GraspingHand::kReach, 0.0)), 1.0);
  advance();
  EXPECT_FALSE(device->holds());
  EXPECT_FALSE(controller().place.feedback().pointsAt);
  // A closed hand takes nothing that it is moved over.
  hold(Pose::translation(q.position + Vector3(0.0, 0.2, 0.0)), 1.0);
  advance(10);
  EXPECT_FALSE(device->holds());
  EXPECT_EQ(q, before);
}

TEST_F(Grasp, WhatItPointsAtIsTakenAtADistance) {
  const Pose before = q;
  hold(Pose::translation(q.position + Vector3(0.05, 0.05, 1.5)), 1.0);
  advance();
  ASSERT_TRUE(device->holds());
  ASSERT_TRUE(controller().place.feedback().pointsAt);
  EXPECT_NEAR(*controller().place.feedback().pointsAt, 1.3, kExact);
  const Pose grip = at;
  move(grip * Pose::translation({0.0, 0.2, 0.0}));
  expectNear(q, Pose::translation(before.position + Vector3(0.0, 0.2, 0.0)));
}

TEST_F(Grasp, TheReachIsThatOfTheRoom) {
  const Pose beside = Pose::translation(q.position + Vector3(0.0, 0.2 + 2.0 * GraspingHand::kReach, 0.0));
  controller().place.set({beside, std::nullopt, 1.0, 1.0});
  advance();
  EXPECT_FALSE(device->holds());
  controller().place.set({beside, std::nullopt, 0.0, 0.25});
  advance();
  controller().place.set({beside, std::nullopt, 1.0, 0.25});
  advance();
  EXPECT_TRUE(device->holds()) << "the product is shown at a quarter of its size";
}

TEST_F(Grasp, ALossOfTrackingIsALostGripThatIsTakenUpAgainWithoutAJump) {
  takeByHand();
  move(at * Pose::translation({-0.1, 0.0, 0.0}));
  const Pose held = q;
  loseTracking();
  advance(10);
  EXPECT_FALSE(device->holds());
  EXPECT_EQ(q, held);
  hold(Pose::translation({1.5, 1.0, 1.5}), 1.0);
  advance(50);
  EXPECT_TRUE(device->holds());
  expectNear(q, held);
  move(at * Pose::translation({-0.1, 0.0, 0.0}));
  expectNear(q, Pose::translation(held.position - Vector3(0.1, 0.0, 0.0)));
}

TEST_F(Grasp, OpenedWhileItIsLostItIsLetGo) {
  takeByHand();
  squeezed = 0.0;
  loseTracking();
  advance();
  hold(Pose::translation({1.5, 1.0, 1.5}), 1.0);
  advance();
  EXPECT_FALSE(device->holds());
}

TEST_F(Grasp, PutElsewhereItIsHeldThere) {
  takeByHand();
  q = Pose::translation({-1.5, 0.5, 0.5});
  const Pose put = q;
  advance(50);
  expectNear(q, put);
  move(at * Pose::translation({0.0, 0.0, 0.1}));
  expectNear(q, Pose::translation(put.position + Vector3(0.0, 0.0, 0.1)));
}

TEST_F(Grasp, ALightSqueezeKeepsWhatAFirmerOneHasTaken) {
  takeByHand();
  squeeze(0.5 * (GraspingHand::kTakes + GraspingHand::kLetsGo));
  advance();
  EXPECT_TRUE(device->holds());
  squeeze(0.9 * GraspingHand::kLetsGo);
  advance();
  EXPECT_FALSE(device->holds());
  squeeze(0.5 * (GraspingHand::kTakes + GraspingHand::kLetsGo));
  advance();
  EXPECT_FALSE(device->holds());
}

TEST_F(Grasp, PulledIntoAWallItStopsSlidesAndIsFelt) {
  takeByHand();
  const Pose grip = at;
  double nearest = 1e9;
  const auto pull = [&](const Vector3& by, int ticks) {
    hold(grip * Pose::translation(by), 1.0);
    for (int i = 0; i < ticks; ++i) {
      advance();
      nearest = std::min(nearest, judge->nearestObstacle(q).distance);
    }
  };
  pull({0.0, 1.0, 0.0}, 400);
  EXPECT_EQ(controller().place.feedback().push, 0.0) << "it is free";
  pull({2.0, 1.0, 0.0}, 400);
  EXPECT_NEAR(q.position.x(), -0.3, 0.01 * radius) << "it is at the wall";
  EXPECT_GT(controller().place.feedback().push, 0.9);
  const Pose stopped = q;
  pull({2.0, 1.0, 0.3}, 400);
  EXPECT_GT(q.position.z() - stopped.position.z(), 0.1) << "it slides";
  EXPECT_GT(nearest, 0.0) << "penetration";
  pull({0.0, 1.0, 0.0}, 400);
  expectNear(q, Pose::translation({-1.2, 1.0, 0.0}));
  EXPECT_EQ(controller().place.feedback().push, 0.0);
}

TEST_F(Grasp, PressedLightlyItIsFeltAllTheTime) {
  takeByHand();
  const double toWall = -0.3 - q.position.x();
  move(at * Pose::translation({0.0, 1.0, 0.0}));
  move(at * Pose::translation({toWall + 0.3 * SlidingHand::kMostLead * radius, 0.0, 0.0}));
  for (int i = 0; i < 20; ++i) {
    advance();
    EXPECT_NEAR(controller().place.feedback().push, 0.3, 0.1) << i;
  }
}

TEST_F(Grasp, ByHandTheMainHandTakesIt) {
  use("hand");
  inputs->mainHand = ControllerSide::Left;
  takeByHand();  // with the right hand
  EXPECT_FALSE(device->holds());
  inputs->mainHand = ControllerSide::Right;
  takeByHand();
  EXPECT_TRUE(device->holds());
  inputs->mainHand = ControllerSide::Left;
  advance();
  EXPECT_FALSE(device->holds());
}

TEST_F(Grasp, KeysMoveItWhileNoControllerHoldsIt) {
  use("hand");
  inputs->keyboard.mailbox.setAxes({0, 0, 1, 0, 0, 0});
  advance(50);
  EXPECT_GT(q.position.z(), 0.0);
  takeByHand();
  const Pose held = q;
  advance(50);
  expectNear(q, held);
}

}  // namespace
}  // namespace glissade
