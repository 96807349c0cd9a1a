#include "widgets/openxr/headset_machine.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

using namespace std::chrono_literals;

class HeadsetMachineTest : public testing::Test {
 protected:
  HeadsetState state() const { return machine_.status().state; }
  std::chrono::nanoseconds waitAfter(HeadsetMachine::Time now) const { return machine_.nextSearch() - now; }

  HeadsetMachine machine_;
  HeadsetMachine::Time now_{1h};
};

TEST_F(HeadsetMachineTest, IsOffUntilItIsAskedForAndThenSearchesAtOnce) {
  EXPECT_EQ(state(), HeadsetState::Off);
  machine_.ask(now_);
  EXPECT_EQ(state(), HeadsetState::Searching);
  EXPECT_EQ(waitAfter(now_), 0s);
}

TEST_F(HeadsetMachineTest, SearchesMoreAndMoreSeldomAndSaysWhy) {
  machine_.ask(now_);
  machine_.failSearch(HeadsetTrouble::NoRuntime, "xrCreateInstance -2", now_);
  EXPECT_EQ(machine_.status().trouble, HeadsetTrouble::NoRuntime);
  EXPECT_EQ(machine_.status().detail, "xrCreateInstance -2");
  EXPECT_EQ(waitAfter(now_), HeadsetMachine::kFirstWait);
  machine_.failSearch(HeadsetTrouble::NoHeadset, "", now_);
  EXPECT_EQ(waitAfter(now_), 2 * HeadsetMachine::kFirstWait);
  for (int i = 0; i < 20; ++i) machine_.failSearch(HeadsetTrouble::NoHeadset, "", now_);
  EXPECT_EQ(waitAfter(now_), HeadsetMachine::kLongestWait);
}

TEST_F(HeadsetMachineTest, OneThatWasShownIsSearchedAtOnceAfterALoss) {
  machine_.ask(now_);
  machine_.failSearch(HeadsetTrouble::NoHeadset, "", now_);
  machine_.connect("headset");
  EXPECT_EQ(state(), HeadsetState::Idle);
  machine_.begin();
  EXPECT_EQ(state(), HeadsetState::Running);
  EXPECT_EQ(machine_.status().name, "headset");
  machine_.lose(HeadsetTrouble::SessionLost, "");
  EXPECT_EQ(state(), HeadsetState::Lost);
  machine_.release(now_);
  EXPECT_EQ(state(), HeadsetState::Searching);
  EXPECT_EQ(machine_.status().trouble, HeadsetTrouble::SessionLost);
  EXPECT_EQ(waitAfter(now_), 0s);
  machine_.failSearch(HeadsetTrouble::NoRuntime, "", now_);
  EXPECT_EQ(waitAfter(now_), HeadsetMachine::kFirstWait);
}

TEST_F(HeadsetMachineTest, OneThatIsLostBeforeItShowsAnythingIsSearchedMoreAndMoreSeldom) {
  machine_.ask(now_);
  for (const auto wait : {500ms, 1000ms, 2000ms}) {
    machine_.connect("headset");
    machine_.lose(HeadsetTrouble::SessionLost, "");
    machine_.release(now_);
    EXPECT_EQ(waitAfter(now_), wait);
  }
}

TEST_F(HeadsetMachineTest, TakenOffItIsIdleAndLeftItWaitsUntilItIsAskedForAgain) {
  machine_.ask(now_);
  machine_.connect("headset");
  machine_.begin();
  machine_.end();
  EXPECT_EQ(state(), HeadsetState::Idle);
  machine_.leave();
  EXPECT_EQ(state(), HeadsetState::Left);
  machine_.ask(now_);
  EXPECT_EQ(state(), HeadsetState::Searching);
  machine_.switchOff();
  EXPECT_EQ(machine_.status(), HeadsetStatus());
}

}  // namespace
}  // namespace glissade
