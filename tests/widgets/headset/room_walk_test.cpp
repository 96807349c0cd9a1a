#include "widgets/openxr/room_walk.h"

#include <gtest/gtest.h>

#include <numbers>

namespace glissade {
namespace {

class RoomWalkTest : public testing::Test {
 protected:
  RoomWalkTest() {
    walk.place(placeRoom(Box3(Vector3(0, 0, 0), Vector3(3, 3, 3)), ProductSize::OnTable));
    input.p_RH = {0.1, 1.6, 0.2};
    for (ControllerState& hand : input.controllers) hand.X_RA = hand.X_RG = Pose::identity();
    left().X_RG->position = {-0.2, 1.0, -0.3};
    right().X_RG->position = {0.2, 1.0, -0.3};
  }
  ControllerState& left() { return input.controllers[0]; }
  ControllerState& right() { return input.controllers[1]; }
  void advance() { walk.advance(input); }
  Vector3 inWorldAt(const Vector3& p_R) const { return inWorld(walk.room(), Pose::translation(p_R)).position; }
  static void expectNear(const Vector3& a, const Vector3& b) { EXPECT_LT((a - b).norm(), 1e-9) << a.transpose(); }
  void expectUpright() const { expectNear(walk.room().X_WR.orientation * Vector3::UnitY(), Vector3::UnitZ()); }

  RoomWalk walk;
  WalkInput input;
};

TEST_F(RoomWalkTest, NothingMovesByItself) {
  const RoomPlacement before = walk.room();
  for (int i = 0; i < 100; ++i) advance();
  right().squeeze = 1.0;  // the main hand takes the object or nothing
  advance();
  right().X_RG->position.x() += 0.3;
  advance();
  EXPECT_EQ(walk.room().X_WR, before.X_WR);
  EXPECT_EQ(walk.room().scale, before.scale);
}

TEST_F(RoomWalkTest, WhatTheOtherHandHasOfTheWorldStaysInIt) {
  left().squeeze = 1.0;
  advance();
  const Vector3 had = inWorldAt(left().X_RG->position);
  left().X_RG->position += Vector3(0.1, -0.2, 0.3);
  advance();
  expectNear(inWorldAt(left().X_RG->position), had);
  expectUpright();
  left().squeeze = 0.0;
  advance();
  const Pose before = walk.room().X_WR;
  left().X_RG->position += Vector3(0.1, -0.2, 0.3);
  advance();
  EXPECT_EQ(walk.room().X_WR, before);
}

TEST_F(RoomWalkTest, ForALeftHandedPersonTheRightHandPulls) {
  input.mainHand = ControllerSide::Left;
  right().squeeze = 1.0;
  advance();
  const Vector3 had = inWorldAt(right().X_RG->position);
  right().X_RG->position.x() += 0.3;
  advance();
  expectNear(inWorldAt(right().X_RG->position), had);
}

TEST_F(RoomWalkTest, BothHandsScaleAndTurnTheWorldUpright) {
  left().squeeze = right().squeeze = 1.0;
  advance();
  const Vector3 inLeft = inWorldAt(left().X_RG->position);
  const Vector3 inRight = inWorldAt(right().X_RG->position);
  const double scale = walk.room().scale;
  left().X_RG->position = {0.1, 1.0, 0.1};
  right().X_RG->position = {0.1, 1.0, -0.7};
  advance();
  expectNear(inWorldAt(left().X_RG->position), inLeft);
  expectNear(inWorldAt(right().X_RG->position), inRight);
  EXPECT_NEAR(walk.room().scale, 2.0 * scale, 1e-9);
  expectUpright();
}

TEST_F(RoomWalkTest, AHandThatHoldsTheObjectDoesNotScale) {
  left().squeeze = right().squeeze = 1.0;
  input.holds[1] = true;
  advance();
  const double scale = walk.room().scale;
  right().X_RG->position.x() += 0.5;
  advance();
  EXPECT_EQ(walk.room().scale, scale);
}

TEST_F(RoomWalkTest, AHandThatHoldsTheObjectDoesNotPull) {
  left().squeeze = 1.0;
  input.holds[0] = true;
  advance();
  const Pose before = walk.room().X_WR;
  left().X_RG->position.x() += 0.5;
  advance();
  EXPECT_EQ(walk.room().X_WR, before);
}

TEST_F(RoomWalkTest, APersonStandsWhereTheyPointedWhenTheStickIsReleased) {
  const Vector3 before = walk.room().X_WR.position;
  // The hand is 1 m above the floor and points 45 degrees down.
  right().X_RA =
      Pose{Vector3(0.3, 1.0, 0.0), Quaternion(Eigen::AngleAxisd(-0.25 * std::numbers::pi, Vector3::UnitX()))};
  right().stick.y() = 1.0;
  advance();
  EXPECT_EQ(walk.room().X_WR.position, before);
  ASSERT_TRUE(walk.target());
  const Vector3 target = *walk.target();
  expectNear(target, inWorldAt({0.3, 0.0, -1.0}));
  right().stick.y() = 0.0;
  advance();
  expectNear(inWorldAt({input.p_RH.x(), 0.0, input.p_RH.z()}), target);
  EXPECT_FALSE(walk.target());
}

TEST_F(RoomWalkTest, ThereIsNoWayUpwards) {
  const Pose before = walk.room().X_WR;
  right().X_RA = Pose{Vector3(0.3, 1.0, 0.0), Quaternion(Eigen::AngleAxisd(0.3, Vector3::UnitX()))};
  for (const double stick : {1.0, 0.0}) {
    right().stick.y() = stick;
    advance();
    EXPECT_FALSE(walk.target());
  }
  EXPECT_EQ(walk.room().X_WR, before);
}

TEST_F(RoomWalkTest, AStickToTheSideTurnsThePersonOnceWhereTheyAre) {
  const Vector3 head = inWorldAt(input.p_RH);
  const Vector3 ahead = walk.room().X_WR.orientation * -Vector3::UnitZ();
  left().stick.x() = 1.0;
  for (int i = 0; i < 10; ++i) advance();
  expectNear(inWorldAt(input.p_RH), head);
  const Vector3 now = walk.room().X_WR.orientation * -Vector3::UnitZ();
  EXPECT_NEAR(std::acos(now.dot(ahead)), RoomWalk::kTurn, 1e-9);
  EXPECT_LT(ahead.cross(now).z(), 0.0) << "to the right";
  expectUpright();
}

}  // namespace
}  // namespace glissade
