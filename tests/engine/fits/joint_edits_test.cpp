#include "engine/fits/joint_edits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/fits/joint_finder.h"
#include "tests/engine/fits/turned_parts.h"

namespace glissade {
namespace {

using namespace glissade::test;
using testing::ElementsAre;
using testing::HasSubstr;

/// A screw, its block, a hook beside the block, a lid on it, and a distant body.
AssembledProduct someProduct() {
  ProductOfParts parts;
  parts.add("block", blockMesh(0.0021, 0.015, 0.03, -0.03, 0.0))
      .add("screw", capScrew(0.005, 0.012))
      .add("hook", rodMesh(0.002, 0.0, 0.02), Pose::translation({0.01, 0.0, 0.0}))
      .add("lid", plateMesh(0.003, 0.03, -0.034, -0.03))
      .add("far", rodMesh(0.002, 0.0, 0.02), Pose::translation({1.0, 0.0, 0.0}));
  return parts.product();
}

Joint turned() {
  Joint joint;
  joint.thread = JointThread{0.005, 0.0008, true, 0.004};
  return joint;
}

std::string errorOf(const JointEdit& edit) {
  const AssembledProduct product = someProduct();
  const auto joints = applied(findJoints(product), {edit}, product);
  return joints ? "" : toString(joints.error());
}

TEST(JointEdits, ConfirmDissolveAndMakeJoints) {
  const AssembledProduct product = someProduct();
  const Joints found = findJoints(product);
  ASSERT_EQ(found.size(), 1U);
  const JointKey screw{JointKind::Screw, "screw", {"block"}};
  EXPECT_EQ(keyOf(found[0], product), screw);
  const auto confirmed = applied(found, {{screw, JointEdit::Word::Confirmed}}, product);
  ASSERT_TRUE(confirmed);
  EXPECT_EQ((*confirmed)[0].state, JointState::Confirmed);
  const auto dissolved = applied(found, {{screw, JointEdit::Word::Dissolved}}, product);
  ASSERT_TRUE(dissolved);
  EXPECT_TRUE(dissolved->empty());
  Joint snap;
  snap.bend = 0.0006;
  const auto made = applied(found, {{{JointKind::Snap, "hook", {"block"}}, JointEdit::Word::Confirmed, snap}}, product);
  ASSERT_TRUE(made) << toString(made.error());
  ASSERT_EQ(made->size(), 2U);
  EXPECT_EQ((*made)[1].kind, JointKind::Snap);
  EXPECT_EQ((*made)[1].body, 2U);
  EXPECT_EQ((*made)[1].bend, 0.0006);
  EXPECT_EQ((*made)[1].state, JointState::Confirmed);
  JointEdit changed{screw, JointEdit::Word::Confirmed, turned(), {"lid"}};
  const auto again = applied(found, {changed}, product);
  ASSERT_TRUE(again) << toString(again.error());
  ASSERT_EQ(again->size(), 1U);
  EXPECT_THAT((*again)[0].clamped, ElementsAre(3U));
}

TEST(JointEdits, AnInsertMayBePressedOutAndAUnitOpened) {
  const AssembledProduct product = someProduct();
  Joints joints(2);
  joints[0].kind = JointKind::Insert;
  joints[0].body = 1;
  joints[0].others = {0};
  joints[1].kind = JointKind::Unit;
  joints[1].body = 2;
  joints[1].others = {3};
  const auto after = applied(joints,
                             {{{JointKind::Insert, "screw", {"block"}}, JointEdit::Word::PressedOut},
                              {{JointKind::Unit, "hook", {"lid"}}, JointEdit::Word::Opened}},
                             product);
  ASSERT_TRUE(after) << toString(after.error());
  ASSERT_EQ(after->size(), 1U);
  EXPECT_EQ((*after)[0].kind, JointKind::Pin);
}

TEST(JointEdits, EachMistakeHasOneMessage) {
  using Word = JointEdit::Word;
  EXPECT_THAT(errorOf({{JointKind::Pin, "hook", {"nobody"}}, Word::Confirmed, Joint{}}),
              HasSubstr("there is no body 'nobody'"));
  EXPECT_THAT(errorOf({{JointKind::Pin, "far", {"block"}}, Word::Confirmed, Joint{}}), HasSubstr("is far from"));
  EXPECT_THAT(errorOf({{JointKind::Pin, "hook", {"hook"}}, Word::Confirmed, Joint{}}), HasSubstr("twice"));
  EXPECT_THAT(errorOf({{JointKind::Pin, "hook", {}}, Word::Confirmed, Joint{}}), HasSubstr("one body only"));
  EXPECT_THAT(errorOf({{JointKind::Pin, "hook", {"block"}}, Word::Dissolved}), HasSubstr("no such joint"));
  EXPECT_THAT(errorOf({{JointKind::Screw, "screw", {"block"}}, Word::PressedOut}), HasSubstr("only an insert"));
  EXPECT_THAT(errorOf({{JointKind::Screw, "screw", {"block"}}, Word::Opened}), HasSubstr("only a unit"));
  Joint snap;
  snap.bend = 0.05;
  EXPECT_THAT(errorOf({{JointKind::Snap, "hook", {"block"}}, Word::Confirmed, snap}),
              HasSubstr("does not bend by 50 mm"));
  EXPECT_THAT(errorOf({{JointKind::Pin, "hook", {"block"}}, Word::Confirmed, snap}), HasSubstr("only a snap bends"));
  EXPECT_THAT(errorOf({{JointKind::Screw, "screw", {"block"}}, Word::Confirmed, Joint{}}),
              HasSubstr("its thread is not stated"));
  Joint unknown = turned();
  unknown.designation = "ISO 99999 M5";
  EXPECT_THAT(errorOf({{JointKind::Screw, "screw", {"block"}}, Word::Confirmed, unknown}),
              HasSubstr("standard that is not known"));
}

TEST(JointEdits, JointsInACircleAreRefused) {
  const AssembledProduct product = someProduct();
  const JointEdit one{{JointKind::Screw, "screw", {"block"}}, JointEdit::Word::Confirmed, turned(), {"hook"}};
  const JointEdit other{{JointKind::Screw, "hook", {"block"}}, JointEdit::Word::Confirmed, turned(), {"screw"}};
  EXPECT_TRUE(applied({}, {one}, product));
  const auto both = applied({}, {one, other}, product);
  ASSERT_FALSE(both);
  EXPECT_THAT(toString(both.error()), HasSubstr("in a circle: 'screw' -> 'hook'"));
  Joint glue;
  const JointEdit glued{{JointKind::Permanent, "screw", {"block"}}, JointEdit::Word::Confirmed, glue};
  EXPECT_TRUE(applied({}, {one, glued}, product)) << "one body does not wait for itself";
}

TEST(JointEdits, SuggestionsAreConfirmedAllAtOnce) {
  const AssembledProduct product = someProduct();
  Joints joints(2);
  joints[0].kind = JointKind::Flexible;
  joints[0].state = JointState::Suggested;
  joints[0].body = 2;
  joints[1].kind = JointKind::Pin;
  joints[1].body = 3;
  joints[1].others = {0};
  const auto edits = confirmationsOf(joints, product);
  ASSERT_EQ(edits.size(), 1U);
  EXPECT_EQ(edits[0].key.body, "hook");
}

}  // namespace
}  // namespace glissade
