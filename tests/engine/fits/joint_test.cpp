#include "engine/fits/joint.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

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
