#include "engine/fits/joint_finder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/fits/thread_pitch.h"
#include "engine/geometry/primitives.h"
#include "tests/engine/fits/turned_parts.h"
#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

using namespace glissade::test;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<Joint> ofKind(const Joints& joints, JointKind kind) {
  std::vector<Joint> found;
  for (const Joint& joint : joints) {
    if (joint.kind == kind) found.push_back(joint);
  }
  return found;
}

/// Drawings of the hole of a thread, with sizes in radii of the screw.
struct Drawing {
  const char* name;
  double hole;
  bool isBlind;
};

class DrawnThread : public testing::TestWithParam<Drawing> {};

/// A screw, a washer, a plate and a block along one axis, M2 to M20.
TEST_P(DrawnThread, IsFoundFromM2ToM20InAnyPose) {
  RandomStream random(1, "joints");
  for (const double size : {2.0, 3.0, 5.0, 8.0, 12.0, 20.0}) {
    const double d = 1e-3 * size;
    const double length = 4.0 * d;
    ProductOfParts parts(randomPose(random, 0.3));
    const double top = -0.2 * d - d;  // top of the block
    const double hole = GetParam().hole * 0.5 * d;
    parts.add("plate", plateMesh(0.56 * d, 6.0 * d, top, -0.2 * d))
        .add("screw", capScrew(d, length))
        .add("block", GetParam().isBlind ? blockMesh(hole, length, 6.0 * d, top - 6.0 * d, top)
                                         : plateMesh(hole, 6.0 * d, top - 2.0 * d, top))
        .add("washer", tubeMesh(circle(0.54 * d), circle(1.1 * d), -0.2 * d, 0.0));
    const Joints joints = findJoints(parts.product());
    const auto screws = ofKind(joints, JointKind::Screw);
    ASSERT_EQ(screws.size(), 1U) << GetParam().name << ", M" << size;
    const Joint& screw = screws[0];
    EXPECT_EQ(screw.body, 1U);
    EXPECT_EQ(screw.state, JointState::Recognised);
    EXPECT_THAT(screw.others, ElementsAre(2U));
    EXPECT_THAT(screw.clamped, ElementsAre(3U, 0U)) << "the washer is nearer to the head";
    EXPECT_GT(screw.direction.dot(parts.direction(Vector3::UnitZ())), 0.9999) << "it leaves on the side of its head";
    ASSERT_TRUE(screw.thread);
    EXPECT_NEAR(screw.thread->diameter, d, 0.01 * d);
    EXPECT_EQ(screw.thread->pitch, coarsePitch(0.5 * d).pitch);
    EXPECT_FALSE(screw.thread->isPitchStated);
    const double travel = length + top;
    EXPECT_NEAR(screw.thread->travel, travel, 0.05 * d);
    EXPECT_NEAR(screw.thread->turns(), travel / screw.thread->pitch, 0.1);
    EXPECT_EQ(screw.drive, DriveKind::HexSocket);
    EXPECT_NEAR(screw.driveSize, 0.8 * d, 0.03 * d);
    EXPECT_THAT(screw.evidence, testing::Not(IsEmpty()));
  }
}

INSTANTIATE_TEST_SUITE_P(Drawings, DrawnThread,
                         testing::Values(Drawing{"as wide as the screw", 1.0, false}, Drawing{"the core", 0.84, false},
                                         Drawing{"plastic that the screw cuts", 0.75, true},
                                         Drawing{"wider than a core that is drawn", 1.06, true},
                                         Drawing{"no hole at all", 1e-3, true}),
                         [](const auto& drawing) { return "Drawing" + std::to_string(drawing.index); });

TEST(JointFinder, ANutThatIsFreeIsTurnedAndAHeldOneIsNot) {
  for (const bool isHeld : {false, true}) {
    ProductOfParts parts;
    parts.add("screw", capScrew(0.008, 0.04))
        .add("plate", plateMesh(0.0045, 0.05, -0.02, 0.0))
        .add("nut", tubeMesh(circle(0.004), prism(0.013, 6), -0.0265, -0.02));
    if (isHeld) parts.add("cage", tubeMesh(prism(0.0131, 6), prism(0.03, 4), -0.0265, -0.02));
    const Joints joints = findJoints(parts.product());
    const auto turned = ofKind(joints, isHeld ? JointKind::Screw : JointKind::Nut);
    ASSERT_EQ(turned.size(), 1U) << isHeld;
    EXPECT_EQ(joints.size(), 1U);
    EXPECT_EQ(turned[0].body, isHeld ? 0U : 2U);
    EXPECT_THAT(turned[0].others, ElementsAre(isHeld ? 2U : 0U));
    EXPECT_THAT(turned[0].clamped, ElementsAre(1U));
    EXPECT_GT(turned[0].direction.z() * (isHeld ? 1.0 : -1.0), 0.999);
    EXPECT_NEAR(turned[0].thread->travel, 0.02, 1e-4) << "the end of the screw is passed, too";
    EXPECT_EQ(turned[0].drive, isHeld ? DriveKind::HexSocket : DriveKind::HexOutside);
    EXPECT_NEAR(turned[0].driveSize, isHeld ? 0.0064 : 0.013, 2e-4);
  }
}

/// A thin shim has one section, which does not tell a hole beside the axis from the crest of a helix.
TEST(JointFinder, AThinShimBesideTheAxisOfAScrewIsNoThread) {
  for (const double aside : {0.0, 0.0005}) {
    const Pose beside = Pose::translation({aside, 0.0, 0.0});
    ProductOfParts parts;
    parts.add("screw", capScrew(0.008, 0.04))
        .add("plate", plateMesh(0.0045, 0.05, -0.02, 0.0))
        .add("ring", tubeMesh(circle(0.004), circle(0.008), -0.021, -0.02), beside)
        .add("nut", tubeMesh(circle(0.0034), prism(0.013, 6), -0.0275, -0.021), beside);
    const Joints joints = findJoints(parts.product());
    ASSERT_EQ(joints.size(), 1U) << aside;
    EXPECT_EQ(joints[0].kind, JointKind::Nut);
    EXPECT_EQ(joints[0].body, 3U);
    EXPECT_THAT(joints[0].others, ElementsAre(0U));
    EXPECT_THAT(joints[0].clamped, ElementsAre(1U, 2U));
  }
}

TEST(JointFinder, ANutOnARodLeavesOverTheNearerEnd) {
  ProductOfParts parts;
  parts.add("rod", rodMesh(0.005, -0.1, 0.1)).add("nut", tubeMesh(circle(0.005), prism(0.016, 6), 0.08, 0.088));
  const Joints joints = findJoints(parts.product());
  const auto nuts = ofKind(joints, JointKind::Nut);
  ASSERT_EQ(nuts.size(), 1U);
  EXPECT_EQ(nuts[0].body, 1U);
  EXPECT_THAT(nuts[0].others, ElementsAre(0U));
  EXPECT_GT(nuts[0].direction.z(), 0.999);
  EXPECT_NEAR(nuts[0].thread->travel, 0.02, 1e-4);
  EXPECT_NEAR(nuts[0].thread->engaged, 0.008, 1e-4);
}

/// A nut M6 is drawn with its core, and its rod is not.
TEST(JointFinder, ANutHasTheSizeOfItsRod) {
  ProductOfParts parts;
  parts.add("rod", rodMesh(0.003, -0.05, 0.05)).add("nut", tubeMesh(circle(0.00246), prism(0.01, 6), 0.02, 0.0255));
  const auto nuts = ofKind(findJoints(parts.product()), JointKind::Nut);
  ASSERT_EQ(nuts.size(), 1U);
  EXPECT_EQ(nuts[0].state, JointState::Recognised);
  EXPECT_NEAR(nuts[0].thread->diameter, 0.006, 1e-5);
  EXPECT_DOUBLE_EQ(nuts[0].thread->pitch, 0.001);
}

/// M58x1.5: a large ring that is thicker than its hole by a thread is screwed in. By more or less it is no thread, and
/// only suggested as an insert.
TEST(JointFinder, ALargeCapIsNoInsert) {
  const auto jointsOfCap = [](double hole) {
    ProductOfParts parts;
    parts.add("housing", tubeMesh(circle(hole), circle(0.04), -0.03, 0.0))
        .add("cap", tubeMesh(circle(0.02), circle(0.029), -0.012, 0.0));
    return findJoints(parts.product());
  };
  const Joints screwed = jointsOfCap(0.028188);
  ASSERT_EQ(screwed.size(), 1U);
  EXPECT_EQ(screwed[0].kind, JointKind::Thread);
  EXPECT_DOUBLE_EQ(screwed[0].thread->pitch, 0.0015);
  EXPECT_THAT(toString(screwed[0].evidence.front()), testing::HasSubstr("1.62 mm thicker")) << "a diameter";
  const Joints between = jointsOfCap(0.0285);
  ASSERT_EQ(between.size(), 1U);
  EXPECT_EQ(between[0].kind, JointKind::Insert);
  EXPECT_EQ(between[0].state, JointState::Suggested);
  const Joints pressed = jointsOfCap(0.02895);
  ASSERT_EQ(pressed.size(), 1U);
  EXPECT_EQ(pressed[0].state, JointState::Recognised) << "by a press fit";
}

/// The insert overlaps the plastic by 0.8 mm: no clash, and the screw does not clamp the plastic.
TEST(JointFinder, AHeatSetInsertIsOneBodyWithItsHost) {
  RandomStream random(2, "joints");
  for (int round = 0; round < 4; ++round) {
    ProductOfParts parts(randomPose(random, 0.2));
    parts.add("plastic", blockMesh(0.0017, 0.01, 0.02, -0.02, -0.003))
        .add("insert", tubeMesh(circle(0.00145), circle(0.0025), -0.007, -0.003))
        .add("cover", plateMesh(0.0017, 0.02, -0.003, 0.0))
        .add("screw", capScrew(0.003, 0.006));
    const Joints joints = findJoints(parts.product());
    const auto inserts = ofKind(joints, JointKind::Insert);
    ASSERT_EQ(inserts.size(), 1U);
    EXPECT_EQ(inserts[0].body, 1U);
    EXPECT_THAT(inserts[0].others, ElementsAre(0U));
    EXPECT_EQ(inserts[0].state, JointState::Recognised);
    const auto screws = ofKind(joints, JointKind::Screw);
    ASSERT_EQ(screws.size(), 1U);
    EXPECT_THAT(screws[0].others, ElementsAre(1U));
    EXPECT_THAT(screws[0].clamped, ElementsAre(2U));
  }
}

/// A heater block of a printer: a nozzle from below and a heat break from above are screwed into one core hole.
ProductOfParts heaterBlock(double hole) {
  ProductOfParts parts;
  parts.add("block", plateMesh(hole, 0.016, 0.0, 0.012))
      .add("nozzle", turnedMesh({{-0.003, circle(0.001)},
                                 {-0.003, prism(0.007, 6)},
                                 {0.0, prism(0.007, 6)},
                                 {0.0, circle(0.003)},
                                 {0.0055, circle(0.003)},
                                 {0.0055, circle(0.001)}},
                                true))
      .add("break", turnedMesh({{0.006, circle(0.001)},
                                {0.006, circle(0.003)},
                                {0.012, circle(0.003)},
                                {0.012, circle(0.005)},
                                {0.03, circle(0.005)},
                                {0.03, circle(0.001)}},
                               true));
  return parts;
}

TEST(JointFinder, PartsThatAreScrewedTogetherWithoutAScrewAreFound) {
  const Joints joints = findJoints(heaterBlock(0.0025).product());
  const auto threads = ofKind(joints, JointKind::Thread);
  ASSERT_EQ(threads.size(), 2U);
  EXPECT_EQ(joints.size(), 2U) << "the nozzle is no insert: it has a hexagon";
  EXPECT_EQ(threads[0].body, 1U);
  EXPECT_THAT(threads[0].others, ElementsAre(0U));
  EXPECT_LT(threads[0].direction.z(), -0.999) << "its hexagon does not pass the hole";
  EXPECT_EQ(threads[0].drive, DriveKind::HexOutside);
  EXPECT_NEAR(threads[0].driveSize, 0.007, 1e-4);
  EXPECT_NEAR(threads[0].thread->diameter, 0.006, 2e-5);
  EXPECT_NEAR(threads[0].thread->engaged, 0.0055, 1e-4);
  EXPECT_EQ(threads[0].thread->pitch, 0.001);
  EXPECT_EQ(threads[1].body, 2U);
  EXPECT_THAT(threads[1].others, ElementsAre(0U));
  EXPECT_GT(threads[1].direction.z(), 0.999) << "its shoulder does not pass the hole";
  EXPECT_NEAR(threads[1].thread->travel, 0.006, 1e-4);
}

/// A disc with a hole in the end of a tube, with less than two turns: M58x1.5, M58x2, M120x2.
TEST(JointFinder, AWideCapIsScrewedIn) {
  for (const auto& [diameter, pitch] : {std::pair(0.058, 0.0015), std::pair(0.058, 0.002), std::pair(0.12, 0.002)}) {
    const double radius = 0.5 * diameter;
    ProductOfParts parts;
    parts.add("tube", tubeMesh(circle(radius - 0.5413 * pitch), circle(radius + 0.003), 0.0, 0.02))
        .add("cap", tubeMesh(circle(0.6 * radius), circle(radius), 0.02 - 1.7 * pitch, 0.02));
    const Joints joints = findJoints(parts.product());
    ASSERT_EQ(joints.size(), 1U) << diameter << " x " << pitch;
    EXPECT_EQ(joints[0].kind, JointKind::Thread);
    EXPECT_EQ(joints[0].state, JointState::Recognised);
    EXPECT_EQ(joints[0].body, 1U);
    EXPECT_DOUBLE_EQ(joints[0].thread->pitch, pitch);
  }
}

TEST(JointFinder, WhatIsThickerByLessThanAThreadIsNotScrewedIn) {
  EXPECT_THAT(ofKind(findJoints(heaterBlock(0.0029).product()), JointKind::Thread), IsEmpty()) << "0.1 of 3 mm";
  EXPECT_THAT(ofKind(findJoints(heaterBlock(0.0031).product()), JointKind::Thread), IsEmpty()) << "it is loose";
}

TEST(JointFinder, ATubeInATubeIsNotScrewedIn) {
  ProductOfParts parts;
  parts.add("inner", tubeMesh(circle(0.005), circle(0.008), 0.0, 0.02))
      .add("outer", tubeMesh(circle(0.008), circle(0.01), 0.0, 0.02));
  EXPECT_THAT(ofKind(findJoints(parts.product()), JointKind::Thread), IsEmpty())
      << "the outer one's outside is wider than the inner one's hole, and nothing is between them";
}

TEST(JointFinder, ADowelIsPressedInWhereItIsThickerThanItsHoleAndAPinWhereItIsNot) {
  for (const bool isPressed : {true, false}) {
    ProductOfParts parts;
    parts.add("block", blockMesh(isPressed ? 0.00199 : 0.002, 0.01, 0.02, -0.02, 0.0))
        .add("pin", rodMesh(0.002, -0.01, 0.006));
    const Joints joints = findJoints(parts.product());
    ASSERT_EQ(joints.size(), 1U) << isPressed;
    EXPECT_EQ(joints[0].kind, isPressed ? JointKind::Insert : JointKind::Pin);
    EXPECT_EQ(joints[0].body, 1U);
    EXPECT_THAT(joints[0].others, ElementsAre(0U));
    if (!isPressed) {
      EXPECT_GT(joints[0].direction.z(), 0.999) << "the hole is blind";
    }
  }
}

/// A shaft with a round head without a recess, as wide as the hole of the block below the plate.
Joints jointsOfHeaded(const std::string& name, double headHeight) {
  ProductOfParts parts;
  parts.add(name, screwMesh(0.005, 0.03, circle(0.00425), headHeight, {}))
      .add("plate", plateMesh(0.0028, 0.02, -0.008, 0.0))
      .add("block", plateMesh(0.0025, 0.02, -0.03, -0.008));
  return findJoints(parts.product());
}

TEST(JointFinder, AHeadOfTheProportionsOfACapScrewMakesAScrewOfAShaftInAHoleOfItsWidth) {
  const Joints cap = jointsOfHeaded("part", 0.005);
  ASSERT_EQ(cap.size(), 1U);
  EXPECT_EQ(cap[0].kind, JointKind::Screw);
  EXPECT_EQ(cap[0].state, JointState::Recognised);
  EXPECT_THAT(cap[0].others, ElementsAre(2U));
  EXPECT_THAT(cap[0].clamped, ElementsAre(1U));
  EXPECT_EQ(cap[0].drive, DriveKind::HexSocket);
  for (const Joints& joints : {jointsOfHeaded("part", 0.0015), jointsOfHeaded("clevis pin", 0.005)}) {
    EXPECT_THAT(ofKind(joints, JointKind::Screw), IsEmpty());
    EXPECT_THAT(ofKind(joints, JointKind::Pin), testing::SizeIs(1));
  }
}

TEST(JointFinder, APinThatIsMillimetresThickerThanItsHoleIsNotPressedIn) {
  ProductOfParts parts;
  parts.add("block", blockMesh(0.004, 0.02, 0.02, -0.02, 0.0)).add("pin", rodMesh(0.006, -0.01, 0.02));
  EXPECT_TRUE(findJoints(parts.product()).empty());
}

/// The edges of the bar are farther from the axis than the faces of the hole.
TEST(JointFinder, ASquareBarInASquareHoleIsNoPin) {
  ProductOfParts parts;
  const Contour side = prism(0.0098, 4);
  parts.add("block", tubeMesh(prism(0.01, 4), prism(0.04, 4), -0.02, 0.0))
      .add("bar", turnedMesh({{-0.02, circle(0.0)}, {-0.02, side}, {0.01, side}, {0.01, circle(0.0)}}, false));
  EXPECT_TRUE(findJoints(parts.product()).empty());
}

TEST(JointFinder, ABallBearingIsAUnit) {
  RandomStream random(3, "joints");
  ProductOfParts parts(randomPose(random, 0.2));
  parts.add("inner", tubeMesh(circle(0.004), circle(0.006), -0.0035, 0.0035))
      .add("outer", tubeMesh(circle(0.009), circle(0.011), -0.0035, 0.0035));
  for (int i = 0; i < 7; ++i) {
    const double angle = 2.0 * kHalfTurn * i / 7;
    parts.add("ball" + std::to_string(i), ballMesh(0.0015),
              Pose::translation({0.0075 * std::cos(angle), 0.0075 * std::sin(angle), 0.0}));
  }
  parts.add("far", ballMesh(0.0015), Pose::translation({0.1, 0.0, 0.0}));
  const Joints joints = findJoints(parts.product());
  ASSERT_EQ(joints.size(), 1U);
  EXPECT_EQ(joints[0].kind, JointKind::Unit);
  EXPECT_EQ(joints[0].state, JointState::Recognised);
  EXPECT_EQ(joints[0].body, 0U);
  EXPECT_EQ(joints[0].others.size(), 8U) << "the outer ring and seven balls";
}

/// A motor with its collars, and with two terminals that are no shaft, in the bore of a gear. A shaft that is many
/// times as thick as a hole is no thread.
TEST(JointFinder, AMotorIsNotScrewedIntoItsGear) {
  for (const bool hasTerminals : {true, false}) {
    TriangleMesh motor = turnedMesh({{-0.022, circle(0.0)},
                                     {-0.022, circle(0.001)},
                                     {-0.0165, circle(0.001)},
                                     {-0.0165, circle(0.003)},
                                     {-0.0145, circle(0.003)},
                                     {-0.0145, circle(0.0095)},
                                     {-0.011, circle(0.0095)},
                                     {-0.011, circle(0.01185)},
                                     {0.0125, circle(0.01185)},
                                     {0.0125, circle(0.0)}},
                                    false);
    for (const double side : {-0.0087, 0.0087}) {
      const Pose at = Pose::translation({side, 0.0, 0.0154});
      if (hasTerminals) append(motor, transformed(makeBox({0.0005, 0.004, 0.0058}), at));
    }
    ProductOfParts parts;
    parts.add("motor", motor).add("gear", tubeMesh(circle(0.00115), circle(0.006), -0.0215, -0.017));
    EXPECT_THAT(findJoints(parts.product()), IsEmpty()) << "terminals: " << hasTerminals;
  }
}

/// A barrel bolt turns in a sleeve bearing. A screw from the other end is in the thread of the bolt.
TEST(JointFinder, ABearingIsNoTappedHole) {
  ProductOfParts parts;
  const Pose turned{{0.0, 0.0, -0.022}, Quaternion(Eigen::AngleAxisd(kHalfTurn, Vector3::UnitX()))};
  parts
      .add("5x20 barrel bolt", turnedMesh({{-0.012, circle(0.0)},
                                           {-0.012, circle(0.0018)},
                                           {-0.02, circle(0.0018)},
                                           {-0.02, circle(0.0025)},
                                           {0.0, circle(0.0025)},
                                           {0.0, circle(0.004)},
                                           {0.002, circle(0.004)},
                                           {0.002, circle(0.0)}},
                                          false))
      .add("5x7x8 sleeve bearing", tubeMesh(circle(0.0025), circle(0.0035), -0.016, -0.008))
      .add("lever", plateMesh(0.0023, 0.02, -0.022, -0.02))
      .add("M4x6 SHCS", capScrew(0.004, 0.006), turned);
  const Joints joints = findJoints(parts.product());
  ASSERT_EQ(joints.size(), 1U);
  EXPECT_EQ(joints[0].kind, JointKind::Screw);
  EXPECT_EQ(joints[0].body, 3U);
  EXPECT_THAT(joints[0].others, ElementsAre(0U));
  EXPECT_THAT(joints[0].clamped, ElementsAre(2U));
}

TEST(JointFinder, WhatOnlyPassesAHoleIsNotJoined) {
  ProductOfParts axle;
  axle.add("axle", screwMesh(0.005, 0.03, circle(0.004), 0.004, {})).add("plate", plateMesh(0.006, 0.05, -0.01, 0.0));
  EXPECT_THAT(findJoints(axle.product()), IsEmpty()) << "a shaft with a head in a wide hole";

  ProductOfParts screw;
  screw.add("screw", capScrew(0.005, 0.03)).add("plate", plateMesh(0.00275, 0.05, -0.01, 0.0));
  EXPECT_THAT(findJoints(screw.product()), IsEmpty()) << "a screw in a clearance hole, and nothing behind it";

  ProductOfParts tubes;
  tubes.add("inner", tubeMesh(circle(0.008), circle(0.01), 0.0, 0.1))
      .add("outer", tubeMesh(circle(0.01), circle(0.012), 0.05, 0.15));
  EXPECT_THAT(findJoints(tubes.product()), IsEmpty()) << "a tube that slides in a tube";

  ProductOfParts knob;
  knob.add("knob", turnedMesh({{0.0, circle(0.003)},
                               {0.0, circle(0.01)},
                               {0.012, circle(0.01)},
                               {0.012, circle(0.0)},
                               {0.01, circle(0.0)},
                               {0.01, circle(0.003)}},
                              false))
      .add("panel", plateMesh(0.0035, 0.05, -0.004, -0.001));
  EXPECT_THAT(findJoints(knob.product()), IsEmpty()) << "a knob";
}

struct DrivenHead {
  DriveKind drive;
  Contour head;
  Contour recess;
  double size;
};

TEST(JointFinder, TheDriveAndItsSizeAreReadFromTheMesh) {
  const double d = 0.005;
  const std::vector<DrivenHead> heads{{DriveKind::HexOutside, prism(0.008, 6), {}, 0.008},
                                      {DriveKind::HexSocket, circle(0.00425), prism(0.004, 6), 0.004},
                                      {DriveKind::Cross, circle(0.0046), cross(0.005, 0.0012), 0.005},
                                      {DriveKind::Slot, circle(0.0046), slot(0.008, 0.0012), 0.0012},
                                      {DriveKind::SixLobe, circle(0.0046), sixLobes(0.004), 0.004},
                                      {DriveKind::None, circle(0.0046), {}, 0.0}};
  RandomStream random(4, "joints");
  for (const DrivenHead& head : heads) {
    ProductOfParts parts(randomPose(random, 0.2));
    parts.add("block", blockMesh(0.0021, 0.015, 0.03, -0.03, 0.0))
        .add("screw", screwMesh(d, 0.012, head.head, 0.0032, head.recess));
    const Joints joints = findJoints(parts.product());
    ASSERT_EQ(joints.size(), 1U) << kDriveNames.of(head.drive);
    EXPECT_EQ(joints[0].drive, head.drive) << kDriveNames.of(joints[0].drive);
    EXPECT_NEAR(joints[0].driveSize, head.size, 0.03 * head.size) << kDriveNames.of(head.drive);
  }
}

/// A screw with a triangular thread of this pitch.
TriangleMesh threadedScrew(double diameter, double pitch) {
  std::vector<Station> stations{{-0.02, circle(0.0)}};
  for (double z = -0.02; z < 0.0; z += std::abs(pitch) / 12.0) {
    stations.push_back({z, [=](double angle) {
                          const double turn = z / pitch - angle / (2.0 * kHalfTurn);
                          const double depth = std::abs(2.0 * (turn - std::floor(turn)) - 1.0);
                          return 0.5 * diameter * (1.0 - 0.18 * depth);
                        }});
  }
  stations.push_back({0.0, circle(0.5 * diameter)});
  stations.push_back({0.0, circle(0.8 * diameter)});
  stations.push_back({0.8 * diameter, circle(0.8 * diameter)});
  stations.push_back({0.8 * diameter, circle(0.0)});
  return turnedMesh(stations, false);
}

TEST(JointFinder, AThreadThatIsModelledStatesItsPitchAndItsHand) {
  for (const double pitch : {0.00125, 0.001, -0.00125}) {
    ProductOfParts parts;
    parts.add("block", blockMesh(0.0034, 0.025, 0.04, -0.04, 0.0)).add("screw", threadedScrew(0.008, pitch));
    const auto screws = ofKind(findJoints(parts.product()), JointKind::Screw);
    ASSERT_EQ(screws.size(), 1U) << pitch;
    EXPECT_TRUE(screws[0].thread->isPitchStated);
    EXPECT_NEAR(screws[0].thread->pitch, pitch, 0.02 * std::abs(pitch));
    EXPECT_GT(screws[0].thread->turns(), 0.0);
  }
}

TEST(JointFinder, ANameIsEvidenceBesideTheShapeWhichWins) {
  const auto screwNamed = [](const std::string& name) {
    ProductOfParts parts;
    parts.add("block", blockMesh(0.0021, 0.015, 0.03, -0.03, 0.0))
        .add(name, screwMesh(0.005, 0.012, circle(0.0046), 0.0032, {}));
    const Joints joints = findJoints(parts.product());
    EXPECT_EQ(joints.size(), 1U) << name;
    return joints.empty() ? Joint{} : joints[0];
  };
  const Joint agreed = screwNamed("DIN 7985 M5x12");
  EXPECT_EQ(agreed.designation, "DIN 7985 M5x12");
  EXPECT_EQ(agreed.drive, DriveKind::Cross) << "nothing is drawn: the name says it";
  EXPECT_FALSE(agreed.isDoubtful);
  const Joint thicker = screwNamed("ISO 4762 M8x12");
  EXPECT_TRUE(thicker.isDoubtful);
  EXPECT_NEAR(thicker.thread->diameter, 0.005, 1e-4);
  EXPECT_TRUE(screwNamed("washer M5").isDoubtful);
  EXPECT_TRUE(screwNamed("part 17").designation.empty());
}

TEST(JointFinder, NamesClassesAndShapesSuggestWhatAPersonConfirms) {
  ProductOfParts parts;
  parts.add("case", plateMesh(0.01, 0.06, 0.0, 0.02))
      .add("Timing Belt 200mm", tubeMesh(circle(0.011), circle(0.012), 0.005, 0.01))
      .add("Belt Cover", plateMesh(0.02, 0.06, 0.02, 0.022))
      .add("side clip", plateMesh(0.01, 0.06, -0.002, 0.0))
      .add("M1/NEMA 17 motor/can", rodMesh(0.004, 0.1, 0.14))
      .add("M1/NEMA 17 motor/flange", plateMesh(0.005, 0.03, 0.14, 0.143))
      .add("thing", tubeMesh(circle(0.001), circle(0.002), 0.2, 0.24));
  std::vector<std::string> classes{"", "", "", "", "", "", "cable"};
  EXPECT_THAT(ofKind(findJoints(parts.product(), {}, classes), JointKind::Snap), IsEmpty())
      << "the clip only touches the case: no hook bends when it leaves";
  classes[3] = "clip";
  const Joints joints = findJoints(parts.product(), {}, classes);
  ASSERT_EQ(joints.size(), 4U);
  for (const Joint& joint : joints) EXPECT_EQ(joint.state, JointState::Suggested);
  EXPECT_EQ(joints[0].kind, JointKind::Flexible);
  EXPECT_EQ(joints[0].body, 1U);
  EXPECT_EQ(joints[1].kind, JointKind::Snap);
  EXPECT_EQ(joints[1].body, 3U);
  EXPECT_THAT(joints[1].others, ElementsAre(0U));
  EXPECT_EQ(joints[2].kind, JointKind::Unit);
  EXPECT_THAT(joints[2].others, ElementsAre(5U));
  EXPECT_EQ(joints[3].kind, JointKind::Flexible);
  EXPECT_EQ(joints[3].body, 6U);
}

/// Each belt would have to leave before the other one.
TEST(JointFinder, BeltsSideBySideDoNotGoAroundEachOther) {
  ProductOfParts parts;
  parts.add("pulley", rodMesh(0.011, 0.0, 0.04))
      .add("Belt 50T", tubeMesh(circle(0.011), circle(0.013), 0.005, 0.015))
      .add("Belt 60T", tubeMesh(circle(0.011), circle(0.013), 0.015, 0.025));
  const Joints joints = findJoints(parts.product());
  std::vector<std::vector<std::size_t>> others;
  for (const Joint& joint : joints) {
    if (joint.kind == JointKind::Flexible) others.push_back(joint.others);
  }
  EXPECT_THAT(others, ElementsAre(ElementsAre(0U), ElementsAre(0U)));
}

/// "Assembly" does not name a part, and a retaining ring is opened for its removal.
TEST(JointFinder, TheWordBeforeAssemblyCounts) {
  ProductOfParts parts;
  parts.add("Battery Tube Assembly/tube", tubeMesh(circle(0.011), circle(0.012), 0.0, 0.1))
      .add("Battery Tube Assembly/end cap", rodMesh(0.0109, 0.0, 0.01))
      .add("Motor Assembly/can", rodMesh(0.004, 0.2, 0.24))
      .add("Motor Assembly/lid", plateMesh(0.005, 0.03, 0.24, 0.243))
      .add("shaft", rodMesh(0.003, 0.3, 0.35))
      .add("EXTERNAL RETAINING RING 94540A", tubeMesh(circle(0.003), circle(0.005), 0.31, 0.311));
  const Joints joints = findJoints(parts.product());
  const auto isSuggested = [&](JointKind kind, std::size_t body) {
    return std::any_of(joints.begin(), joints.end(), [&](const Joint& joint) {
      return joint.kind == kind && joint.body == body && joint.state == JointState::Suggested;
    });
  };
  EXPECT_FALSE(isSuggested(JointKind::Unit, 0));
  EXPECT_TRUE(isSuggested(JointKind::Unit, 2));
  EXPECT_TRUE(std::any_of(joints.begin(), joints.end(), [](const Joint& joint) {
    return joint.kind == JointKind::Flexible && joint.body == 5 && joint.state == JointState::Recognised &&
           joint.others == std::vector<std::size_t>{4};
  }));
}

/// The bodies of each unit of this state.
std::vector<std::vector<std::size_t>> unitsOf(const AssembledProduct& product, JointState state) {
  std::vector<std::vector<std::size_t>> units;
  for (const Joint& joint : findJoints(product)) {
    if (joint.kind != JointKind::Unit || joint.state != state) continue;
    units.push_back({joint.body});
    units.back().insert(units.back().end(), joint.others.begin(), joint.others.end());
  }
  return units;
}

/// Connectors with pins in the board and beside each other, and a jack that is drawn 0.1 mm above the board. The
/// housing and the aerial are not on the board.
TEST(JointFinder, ACircuitBoardAndWhatIsOnItAreAUnit) {
  const auto boardOf = [](const std::string& assembly, double thickness, JointState state) {
    ProductOfParts parts;
    parts.add("housing", makeBox({0.2, 0.1, 0.01}), Pose::translation({0.0, 0.0, -0.01}))
        .add(assembly + "/base station", makeBox({0.08, 0.05, thickness}))
        .add(assembly + "/header/pins", makeBox({0.02, 0.002, 0.01}), Pose::translation({0.01, 0.0, 0.002}))
        .add(assembly + "/header/socket", makeBox({0.02, 0.004, 0.004}), Pose::translation({0.01, 0.0, 0.006}))
        .add(assembly + "/jack", makeBox({0.01, 0.01, 0.01}), Pose::translation({-0.02, 0.0, 0.5 * thickness + 0.0051}))
        .add(assembly + "/aerial", makeBox({0.01, 0.01, 0.05}), Pose::translation({-0.02, 0.04, 0.04}));
    return unitsOf(parts.product(), state);
  };
  EXPECT_EQ(boardOf("main PCB", 0.0016, JointState::Recognised), (std::vector<std::vector<std::size_t>>{{1, 2, 3, 4}}));
  EXPECT_TRUE(boardOf("base", 0.0016, JointState::Recognised).empty()) << "the name says nothing";
  EXPECT_EQ(boardOf("main PCB", 0.02, JointState::Suggested), (std::vector<std::vector<std::size_t>>{{1, 2, 3, 4, 5}}))
      << "a block";
}

TEST(JointFinder, AnArticleOfASupplierIsAUnit) {
  const auto unitOf = [](const std::string& assembly) {
    ProductOfParts parts;
    parts.add("plate", makeBox({0.2, 0.1, 0.01}), Pose::translation({0.0, 0.0, -0.1}))
        .add(assembly + "/housing", makeBox({0.05, 0.05, 0.05}))
        .add(assembly + "/jaw", makeBox({0.01, 0.01, 0.05}), Pose::translation({0.0, 0.0, 0.06}));
    return unitsOf(parts.product(), JointState::Recognised);
  };
  EXPECT_EQ(unitOf("SCHUNK-1343465 MPC 75"), (std::vector<std::vector<std::size_t>>{{1, 2}}));
  EXPECT_TRUE(unitOf("SCHUNK gripper").empty());
  EXPECT_TRUE(unitOf("gripper 1343465").empty());
}

TEST(JointFinder, TheSameProductHasTheSameJoints) {
  const auto once = [] {
    ProductOfParts parts;
    for (int i = 0; i < 5; ++i) {
      const Pose at = Pose::translation({0.1 * i, 0.0, 0.0});
      parts.add("b" + std::to_string(i), blockMesh(0.0021, 0.015, 0.03, -0.03, 0.0), at)
          .add("s" + std::to_string(i), capScrew(0.005, 0.012), at);
    }
    return findJoints(parts.product());
  };
  const Joints first = once();
  const Joints second = once();
  ASSERT_EQ(first.size(), 5U);
  ASSERT_EQ(second.size(), 5U);
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].body, 2 * i + 1);
    EXPECT_EQ(first[i].point, second[i].point);
    EXPECT_EQ(first[i].thread->travel, second[i].thread->travel);
    EXPECT_EQ(first[i].evidence, second[i].evidence);
  }
}

}  // namespace
}  // namespace glissade
