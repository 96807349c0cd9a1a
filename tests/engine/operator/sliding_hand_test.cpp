// Tests the object in a person's hand among obstacles. FCL judges.
#include "engine/operator/sliding_hand.h"

#include <gtest/gtest.h>

#include "engine/base/random_stream.h"
#include "engine/base/tolerances.h"
#include "engine/operator/shaped_device.h"
#include "tests/engine/operator/operator_support.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

constexpr double kHandTick = 0.008;

class HandInTheWindow : public testing::Test {
 protected:
  HandInTheWindow() { inputs->gamepad.mailbox.connect("pad"); }

  void deflect(const RawAxes& axes) { inputs->gamepad.mailbox.setAxes(axes); }
  void advance() {
    OperatorView view = viewOf(q);
    view.frame.speed = {0.5, 1.0};
    q = device.advance(kHandTick, view, kRoom);
  }
  /// The smallest distance by FCL; 0 in collision.
  double holdFor(double seconds) {
    double nearest = 1e9;
    for (double t = 0.0; t < seconds; t += kHandTick) {
      advance();
      nearest = std::min(nearest, judge->nearestObstacle(q).distance);
    }
    return nearest;
  }

  Problem problem = windowProblem();
  double radius = problem.world->objectRadius();
  std::unique_ptr<CollisionQuery> judge = problem.world->withBackend(CollisionBackend::Fcl)->makeQuery();
  HandInputsPtr inputs = std::make_shared<HandInputs>();
  SlidingHand device{problem.world, std::make_unique<ShapedDevice>(inputs, inputs->gamepad)};
  Pose q = Pose::translation({-1.0, 1.0, 0.0});
};

TEST_F(HandInTheWindow, HeldIntoAWallForFiveSecondsItDoesNotPenetrate) {
  deflect({1, 0, 0, 0, 0, 0});
  EXPECT_GT(holdFor(5.0), 0.0) << "penetration";
  EXPECT_NEAR(q.position.x(), -0.3, 2.0 * tolerance::kContactGap * radius) << "it is at the wall";
  ASSERT_TRUE(device.hand());
  EXPECT_GT(device.hand()->position.x(), q.position.x());
  EXPECT_LE((device.hand()->position - q.position).norm(), SlidingHand::kMostLead * radius + 1e-9);
  ASSERT_TRUE(device.rendered());
  EXPECT_LT(device.rendered()->force_W.x(), -0.9) << "the wall pushes back";
}

TEST_F(HandInTheWindow, AnySteeringForMinutesNeverPenetrates) {
  RandomStream stream(7, "keys");
  for (int hold = 0; hold < 150; ++hold) {
    RawAxes axes{};
    for (double& axis : axes) axis = std::round(stream.uniform(-1.49, 1.49));
    axes[0] = std::abs(axes[0]);  // towards the wall
    deflect(axes);
    ASSERT_GT(holdFor(0.4), 0.0) << "hold " << hold;
  }
}

TEST_F(HandInTheWindow, SlidesAlongTheWallItIsHeldAgainst) {
  deflect({1, 0, 0, 0, 0, 0});
  holdFor(3.0);
  const double before = q.position.z();
  deflect({1, 0, 1, 0, 0, 0});
  EXPECT_GT(holdFor(3.0), 0.0);
  EXPECT_GT(q.position.z() - before, 0.15);
}

TEST_F(HandInTheWindow, ALostGripIsTakenUpWithoutAJump) {
  deflect({1, 0, 0, 0, 0, 0});
  holdFor(4.0);
  const Pose held = q;
  deflect({});
  advance();
  EXPECT_EQ(q, held);
  EXPECT_FALSE(device.hand());
  deflect({-1, 0, 0, 0, 0, 0});
  advance();
  EXPECT_LT(q.position.x(), held.position.x()) << "away from the wall at once";
  EXPECT_LT(longestWay(q, held, radius), 0.5 * kHandTick + 1e-9) << "no farther than the hand's speed";
}

TEST_F(HandInTheWindow, PutElsewhereTheHandGoesOnFromThere) {
  deflect({1, 0, 0, 0, 0, 0});
  holdFor(4.0);
  q = Pose::translation({-1.5, 1.0, 0.0});
  advance();
  EXPECT_NEAR(q.position.x(), -1.5, 0.5 * kHandTick + 1e-9);
  EXPECT_FALSE(device.hand());
}

TEST_F(HandInTheWindow, NearObstaclesItIsSlower) {
  q = Pose::translation({-1.9, 1.0, 0.0});
  deflect({0, 1, 0, 0, 0, 0});
  advance();
  const Pose far = q;
  advance();
  const double fast = (q.position - far.position).norm();
  q = Pose::translation({-0.3 - 0.05 * radius, 1.0, 0.0});
  advance();
  const Pose near = q;
  advance();
  const double slow = (q.position - near.position).norm();
  EXPECT_GT(slow, 0.0);
  EXPECT_LT(slow, 0.7 * fast);
}

TEST_F(HandInTheWindow, PutIntoAWallItComesOutByItself) {
  q = Pose::translation({-0.2, 1.0, 0.0});
  ASSERT_TRUE(problem.world->makeQuery()->collides(q));
  deflect({-1, 0, 0, 0, 0, 0});
  holdFor(2.0);
  EXPECT_LT(q.position.x(), -0.3);
}

}  // namespace
}  // namespace glissade
