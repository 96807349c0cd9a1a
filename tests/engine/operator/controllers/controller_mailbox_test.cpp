#include "engine/operator/controllers/controller_mailbox.h"

#include <gtest/gtest.h>

#include <limits>
#include <thread>

namespace glissade {
namespace {

using namespace std::chrono_literals;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(ControllerMailbox, TheLatestReadingWinsAndTheListenerIsCalled) {
  ControllerMailbox mailbox(std::nullopt);
  int calls = 0;
  mailbox.setListener([&calls] { ++calls; });
  mailbox.set({Pose::translation({1, 0, 0}), std::nullopt, 0.2, 1.0});
  mailbox.set({Pose::translation({2, 0, 0}), std::nullopt, 0.7, 0.5});
  EXPECT_EQ(calls, 2);
  EXPECT_EQ(mailbox.reading().X_WG, Pose::translation({2, 0, 0}));
  EXPECT_EQ(mailbox.reading().squeeze, 0.7);
  EXPECT_EQ(mailbox.reading().scale, 0.5);
}

TEST(ControllerMailbox, WhatIsNoPoseAndNoShareIsNotTaken) {
  ControllerMailbox mailbox(std::nullopt);
  mailbox.set({Pose::translation({kNan, 0, 0}), Pose{Vector3::Zero(), Quaternion(2, 0, 0, 0)}, kNan, 1.0});
  EXPECT_FALSE(mailbox.reading().X_WG);
  EXPECT_FALSE(mailbox.reading().X_WA);
  EXPECT_EQ(mailbox.reading().squeeze, 0.0);
  mailbox.set({std::nullopt, std::nullopt, 7.0, 1.0});
  EXPECT_EQ(mailbox.reading().squeeze, 1.0);
  mailbox.setFeedback({true, -1.0});
  EXPECT_EQ(mailbox.feedback().push, 0.0);
  mailbox.setFeedback({true, 3.0});
  EXPECT_EQ(mailbox.feedback().push, 1.0);
}

TEST(ControllerMailbox, AfterSilenceItIsNotTrackedAndTheHandIsAsItWas) {
  ControllerMailbox mailbox(1ms);
  mailbox.set({Pose::identity(), Pose::identity(), 0.9, 1.0});
  std::this_thread::sleep_for(5ms);
  EXPECT_FALSE(mailbox.reading().X_WG);
  EXPECT_FALSE(mailbox.reading().X_WA);
  EXPECT_EQ(mailbox.reading().squeeze, 0.9);
}

}  // namespace
}  // namespace glissade
