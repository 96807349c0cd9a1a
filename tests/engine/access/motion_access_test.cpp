// Hands among simple bodies. FCL is the independent oracle: it shares the shapes of the hand with the checker, but
// neither the search nor the kernel.
#include "engine/access/motion_access.h"

#include <gtest/gtest.h>

#include "engine/access/object_holds.h"
#include "engine/access/placed_hand.h"
#include "tests/engine/fits/ring.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

std::vector<Pose> straight(const Vector3& way) { return {Pose::identity(), Pose::translation(way)}; }

RigidBody tubeBody(double inner, double outer, double height) {
  RigidBody tube = boxBody("tube", {1.0, 1.0, 1.0}, Pose::translation({0.0, 0.0, 0.5 * height}));
  tube.mesh = std::make_shared<const TriangleMesh>(test::makeRing(inner, outer, height, 48));
  return tube;
}

/// A pin on the floor of a round pocket, which leaves upwards.
std::vector<RigidBody> pinInPocket(double radius, double depth) {
  std::vector<RigidBody> bodies{boxBody("pin", {0.012, 0.012, 0.03}, Pose::translation({0.0, 0.0, 0.0151}))};
  bodies.push_back(tubeBody(radius, radius + 0.02, depth));
  bodies.push_back(
      boxBody("floor", {2.0 * radius + 0.04, 2.0 * radius + 0.04, 0.01}, Pose::translation({0.0, 0.0, -0.005})));
  return bodies;
}

MotionAccess accessOf(const std::vector<RigidBody>& bodies, HandSize size, ToolKind tool = ToolKind::None) {
  ReachedMotion motion{{0}, {}, straight({0.0, 0.0, 0.4}), tool};
  for (std::size_t i = 1; i < bodies.size(); ++i) motion.others.push_back(i);
  return AccessChecker(bodies, {size, std::nullopt}).of(motion, {});
}

/// True if a mesh touches a body, by FCL.
bool fclTouches(const MeshPtr& mesh, const Pose& X_WM, const std::vector<RigidBody>& bodies) {
  return CollisionWorld::build(bodies, mesh, CollisionBackend::Fcl)->makeQuery()->collides(X_WM);
}

std::vector<RigidBody> withoutFirst(std::vector<RigidBody> bodies) {
  bodies.erase(bodies.begin());
  return bodies;
}

TEST(MotionAccess, AWideShallowPocketIsReachedAndADeepNarrowOneIsNot) {
  EXPECT_EQ(accessOf(pinInPocket(0.15, 0.04), HandSize::LargeMan).hand.access, HandAccess::Free);
  const MotionAccess deep = accessOf(pinInPocket(0.03, 0.2), HandSize::SmallWoman);
  EXPECT_EQ(deep.hand.access, HandAccess::Blocked);
  EXPECT_GT(deep.hand.tried, 100U) << "many holds were tried";
  EXPECT_TRUE(deep.hand.blockedBy);
  EXPECT_TRUE(deep.hand.bends.back()) << "free where the pin is out";
  EXPECT_FALSE(deep.hand.bends.front());
  EXPECT_GT(deep.hand.share, 0.0);
  EXPECT_FALSE(placedHand(deep, Pose::identity()).isFree);
  EXPECT_TRUE(placedHand(deep, Pose::translation({0.0, 0.0, 0.4})).isFree);
}

TEST(MotionAccess, FclFindsNoTouchWhereTheHandIsFree) {
  const std::vector<RigidBody> bodies = pinInPocket(0.09, 0.05);
  const MotionAccess access = accessOf(bodies, HandSize::Average);
  ASSERT_EQ(access.hand.access, HandAccess::Free);
  ASSERT_EQ(access.hand.bends.size(), access.samples.size());
  for (const auto& bend : access.hand.bends) ASSERT_TRUE(bend);
  HandShapes shapes(HandSize::Average);
  const std::vector<RigidBody> others = withoutFirst(bodies);
  for (std::size_t i = 0; i < access.samples.size(); i += 3) {
    const HandHold& hold = access.hand.holdAt(i);
    const Pose X_WH = access.samples[i].moved * hold.X_WH;
    EXPECT_FALSE(fclTouches(hold.hand, X_WH, others)) << i;
    EXPECT_FALSE(fclTouches(shapes.forearm(), X_WH * wristBends()[*access.hand.bends[i]], others)) << i;
  }
  const HandHold& hold = access.hand.hold;
  EXPECT_FALSE(fclTouches(hold.hand, hold.X_WH, {bodies.front()})) << "fingers do not go through what they hold";
}

TEST(MotionAccess, FclFindsEveryHoldBlockedWhereNoneIsFree) {
  const std::vector<RigidBody> bodies = pinInPocket(0.03, 0.2);
  ASSERT_EQ(accessOf(bodies, HandSize::Average).hand.access, HandAccess::Blocked);
  HandShapes shapes(HandSize::Average);
  const TriangleMesh pin = transformed(*bodies.front().mesh, bodies.front().X_WB);
  const std::vector<RigidBody> others = withoutFirst(bodies);
  const std::vector<HandHold> holds = objectHolds(pin, Vector3::UnitZ(), Vector3::UnitZ(), shapes);
  ASSERT_GT(holds.size(), 50U);
  std::size_t asked = 0;
  for (std::size_t i = 0; i < holds.size(); i += holds.size() / 40) {
    const HandHold& hold = holds[i];
    if (fclTouches(hold.hand, hold.X_WH, {bodies.front()})) continue;
    ++asked;
    bool blocked = fclTouches(hold.hand, hold.X_WH, others);
    for (std::size_t bend = 0; !blocked && bend < wristBends().size(); ++bend) {
      blocked = fclTouches(shapes.forearm(), hold.X_WH * wristBends()[bend], others);
      if (!blocked) break;
    }
    EXPECT_TRUE(blocked) << i;
  }
  EXPECT_GT(asked, 10U);
}

/// The radius of the narrowest pocket, in steps of 4 mm, from which the hand can take the pin.
double narrowestPocket(HandSize size) {
  double radius = 0.1;
  while (radius > 0.02 && accessOf(pinInPocket(radius, 0.08), size).hand.access == HandAccess::Free) radius -= 0.004;
  return radius;
}

TEST(MotionAccess, ALargerHandNeedsAWiderPocket) {
  const double small = narrowestPocket(HandSize::SmallWoman);
  const double average = narrowestPocket(HandSize::Average);
  const double large = narrowestPocket(HandSize::LargeMan);
  EXPECT_GT(small, 0.02);
  EXPECT_LT(small, large);
  EXPECT_LE(small, average);
  EXPECT_LE(average, large);
}

TEST(MotionAccess, WhatIsTooThickForAHandHasNoGrip) {
  const std::vector<RigidBody> bodies{boxBody("block", {0.4, 0.4, 0.4}, Pose::identity())};
  const MotionAccess access = accessOf(bodies, HandSize::LargeMan);
  EXPECT_EQ(access.hand.access, HandAccess::NoGrip);
  EXPECT_FALSE(access.hasHold());
  EXPECT_TRUE(access.sight.isSeen());
}

/// A screw, head up, with its shaft in the ground.
std::vector<RigidBody> screwInPlate() {
  RigidBody screw = boxBody("screw", {1.0, 1.0, 1.0}, Pose::identity());
  TriangleMesh mesh = test::makeRing(0.0, 0.004, 0.04, 24);
  append(mesh, transformed(test::makeRing(0.0, 0.007, 0.008, 24), Pose::translation({0.0, 0.0, 0.024})));
  screw.mesh = std::make_shared<const TriangleMesh>(mesh);
  RigidBody plate = boxBody("plate", {1.0, 1.0, 1.0}, Pose::translation({0.0, 0.0, 0.0095}));
  plate.mesh = std::make_shared<const TriangleMesh>(test::makeRing(0.0045, 0.15, 0.02, 24));
  return {screw, plate};
}

TEST(MotionAccess, TheForearmIsBehindAScrewdriver) {
  const MotionAccess access = accessOf(screwInPlate(), HandSize::Average, ToolKind::Screwdriver);
  ASSERT_EQ(access.hand.access, HandAccess::Free);
  EXPECT_EQ(access.tool, ToolKind::Screwdriver);
  ASSERT_TRUE(access.hand.hold.tool);
  const PlacedHand placed = placedHand(access, Pose::identity());
  EXPECT_TRUE(placed.isFree);
  const Vector3 toElbow = -(placed.X_WF.orientation * Vector3::UnitZ());
  EXPECT_GT(toElbow.z(), 0.9) << "in line with the screw";
  EXPECT_NEAR((placed.X_WT.orientation * Vector3::UnitZ()).z(), 1.0, 1e-9);
  EXPECT_GT(placed.X_WH.position.z(), 0.1) << "the wrist is beyond the handle";
}

TEST(MotionAccess, EveryToolIsHeldWithoutAHandInThePlate) {
  for (const ToolKind tool : {ToolKind::HexKey, ToolKind::Socket, ToolKind::OpenWrench}) {
    const std::vector<RigidBody> bodies = screwInPlate();
    const MotionAccess access = accessOf(bodies, HandSize::LargeMan, tool);
    ASSERT_EQ(access.hand.access, HandAccess::Free) << kToolNames.of(tool);
    const PlacedHand placed = placedHand(access, Pose::identity());
    EXPECT_FALSE(fclTouches(placed.hand, placed.X_WH, withoutFirst(bodies))) << kToolNames.of(tool);
    EXPECT_FALSE(fclTouches(placed.tool, placed.X_WT, withoutFirst(bodies))) << kToolNames.of(tool);
    const double across = (placed.X_WH.position - access.hand.hold.X_WT.position).head<2>().norm();
    EXPECT_GT(across, 0.03) << "at the end of the handle: " << kToolNames.of(tool);
  }
}

TEST(MotionAccess, AWallAboutTheHeadBlocksTheHandleOfAWrench) {
  std::vector<RigidBody> bodies = screwInPlate();
  RigidBody wall = tubeBody(0.03, 0.04, 0.3);
  wall.X_WB.position.z() = 0.17;
  bodies.push_back(wall);
  EXPECT_EQ(accessOf(bodies, HandSize::SmallWoman, ToolKind::OpenWrench).hand.access, HandAccess::Blocked);
}

TEST(MotionAccess, AFlatPartIsPushedIntoItsPlace) {
  // A disc in a recess of its height: only its face can be touched.
  std::vector<RigidBody> bodies{boxBody("lid", {0.03, 0.03, 0.004}, Pose::translation({0.0, 0.0, 0.0021}))};
  bodies.push_back(boxBody("floor", {0.2, 0.2, 0.01}, Pose::translation({0.0, 0.0, -0.005})));
  for (const double side : {-1.0, 1.0}) {
    bodies.push_back(boxBody("x", {0.08, 0.2, 0.004}, Pose::translation({side * 0.0553, 0.0, 0.0021})));
    bodies.push_back(boxBody("y", {0.0304, 0.08, 0.004}, Pose::translation({0.0, side * 0.0553, 0.0021})));
  }
  const MotionAccess access = accessOf(bodies, HandSize::Average);
  ASSERT_EQ(access.hand.access, HandAccess::Free);
  EXPECT_GT(access.hand.pushed, 0U);
  EXPECT_NE(access.hand.holdAt(0).hand, access.hand.hold.hand) << "a stretched finger";
  EXPECT_EQ(access.hand.bends.size(), access.samples.size());
}

TEST(MotionAccess, AStoppedQuestionHasNoAnswer) {
  StopSource stop;
  stop.requestStop();
  ReachedMotion motion{{0}, {1, 2}, straight({0.0, 0.0, 0.4}), ToolKind::None};
  AccessChecker checker(pinInPocket(0.15, 0.04), {HandSize::Average, std::nullopt});
  EXPECT_EQ(checker.of(motion, stop.token()).hand.access, HandAccess::NotAsked);
}

TEST(HandWay, FingersThatGripAgainDoNotTurnWithAScrew) {
  std::vector<Pose> turns;
  for (int i = 0; i <= 12; ++i) {
    Pose pose = Pose::translation({0.0, 0.0, 0.001 * i});
    pose.orientation = Quaternion(Eigen::AngleAxisd(0.5 * i, Vector3::UnitZ()));
    turns.push_back(pose);
  }
  const HandFollow follow = followOf(turns, Vector3::Zero());
  for (const HandSample& sample : samplesOf(turns, follow, Vector3::Zero())) {
    EXPECT_EQ(angleBetween(sample.moved.orientation, Quaternion::Identity()), 0.0);
  }
  EXPECT_NEAR(samplesOf(turns, follow, Vector3::Zero()).back().moved.position.z(), 0.012, 1e-9);
  const std::vector<Pose> quarter{turns[0], turns[3]};
  EXPECT_GT(angleBetween(followOf(quarter, Vector3::Zero()).movedWith(turns[3]).orientation, Quaternion::Identity()),
            1.0);
  const auto still = samplesOf(turns, HandFollow::still(), Vector3::Zero());
  ASSERT_EQ(still.size(), 1U) << "the bolt stays where its nut is held, and so does the hand";
  EXPECT_EQ(still[0].moved, Pose::identity());
}

}  // namespace
}  // namespace glissade
