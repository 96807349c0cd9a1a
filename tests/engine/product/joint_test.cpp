#include "engine/product/joint.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

TEST(Joint, KindsStatesAndDrivesHaveNames) {
  for (int i = 0; i <= static_cast<int>(JointKind::Unit); ++i) {
    const auto kind = static_cast<JointKind>(i);
    EXPECT_EQ(jointByName(jointName(kind)), kind);
  }
  for (const JointState state : {JointState::Recognised, JointState::Suggested, JointState::Confirmed}) {
    EXPECT_EQ(jointStateByName(jointStateName(state)), state);
  }
  for (int i = 0; i <= static_cast<int>(DriveKind::SixLobe); ++i) {
    const auto drive = static_cast<DriveKind>(i);
    EXPECT_EQ(driveByName(driveName(drive)), drive);
  }
  EXPECT_FALSE(jointByName("rivet"));
  EXPECT_FALSE(jointStateByName(""));
  EXPECT_FALSE(driveByName("torx"));
}

TEST(Joint, TurnsAreThoseUntilTheThreadIsFree) {
  JointThread thread{0.008, -0.00125, true, 0.005};
  EXPECT_NEAR(thread.turns(), 4.0, 1e-9) << "whatever the hand";
  thread.travel = 0.01;
  EXPECT_NEAR(thread.turns(), 8.0, 1e-9) << "a nut passes the end of its shaft, too";
  EXPECT_EQ(JointThread{}.turns(), 0.0);
}

TEST(Joint, EditsAreEqualWhereTheySayTheSame) {
  JointEdit a{{JointKind::Screw, "s", {"b"}}, JointEdit::Word::Confirmed, Joint{}};
  JointEdit b = a;
  EXPECT_EQ(a, b);
  b.made->body = 7;
  EXPECT_EQ(a, b) << "indices are of one product";
  b.made->thread = JointThread{};
  EXPECT_FALSE(a == b);
  a.made->thread = JointThread{};
  a.made->thread->pitch = 0.001;
  EXPECT_FALSE(a == b);
  b = a;
  b.word = JointEdit::Word::Dissolved;
  EXPECT_FALSE(a == b);
  b = a;
  b.clamped = {"c"};
  EXPECT_FALSE(a == b);
}

}  // namespace
}  // namespace glissade
