#include "widgets/openxr/pointer_mailbox.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

using Moment = PointerMailbox::Moment;

Moment at(double x, bool pressed = false) { return PanelPointer{{x, 0.5}, pressed}; }

TEST(PointerMailbox, NoPressAndNoReleaseIsLostAndTheLatestMotionIsLeft) {
  PointerMailbox mailbox;
  for (const Moment& moment :
       {at(0.1), at(0.2), at(0.3), at(0.3, true), at(0.4, true), at(0.5, true), at(0.5), at(0.6), Moment()}) {
    mailbox.set(moment);
  }
  const std::vector<Moment> expected{at(0.1), at(0.3), at(0.3, true), at(0.5, true), at(0.5), at(0.6), Moment()};
  EXPECT_EQ(mailbox.take(), expected);
  EXPECT_TRUE(mailbox.take().empty());
}

TEST(PointerMailbox, ManyMotionsTakeNoRoom) {
  PointerMailbox mailbox;
  for (int i = 0; i < 10000; ++i) mailbox.set(at(1e-4 * i));
  EXPECT_LE(mailbox.take().size(), 2U);
}

TEST(PointerMailbox, WhoListensIsCalledForWhatIsNew) {
  PointerMailbox mailbox;
  int calls = 0;
  mailbox.setListener([&calls] { ++calls; });
  mailbox.set(std::nullopt);
  EXPECT_EQ(calls, 0) << "nobody pointed at it before";
  mailbox.set(at(0.1));
  mailbox.set(at(0.1));
  EXPECT_EQ(calls, 1);
  mailbox.set(std::nullopt);
  EXPECT_EQ(calls, 2);
}

}  // namespace
}  // namespace glissade
