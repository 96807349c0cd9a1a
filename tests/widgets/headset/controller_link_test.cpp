#include "widgets/openxr/controller_link.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

class ControllerLinkTest : public testing::Test {
 protected:
  ControllerLinkTest() {
    room.scale = 0.5;
    room.X_WR.position = {1.0, 2.0, 3.0};
    right().name = "oculus/touch_controller";
  }
  ControllerState& right() { return states[1]; }
  std::uint32_t presses(ControllerButton button) {
    return hand->rightController.buttons.mailbox.reading().presses[static_cast<std::size_t>(button)];
  }
  void take() { link->take(states, room); }

  HandInputsPtr hand = std::make_shared<HandInputs>(std::nullopt);
  std::unique_ptr<ControllerLink> link = std::make_unique<ControllerLink>(hand);
  RoomPlacement room;
  BothControllers states;
};

TEST_F(ControllerLinkTest, PlacesAreThoseOfTheWorld) {
  right().X_RG = Pose::translation({0.1, 0.0, 0.0});
  right().squeeze = 0.4;
  take();
  const ControllerReading reading = hand->rightController.place.reading();
  ASSERT_TRUE(reading.X_WG);
  EXPECT_LT((reading.X_WG->position - Vector3(1.2, 2.0, 3.0)).norm(), 1e-12);
  EXPECT_FALSE(reading.X_WA);
  EXPECT_EQ(reading.squeeze, 0.4);
  EXPECT_EQ(reading.scale, 0.5);
  EXPECT_FALSE(hand->leftController.place.reading().X_WG);
}

TEST_F(ControllerLinkTest, ControllersComeAndGoWithTheirNames) {
  take();
  EXPECT_EQ(hand->rightController.buttons.mailbox.reading().name, "oculus/touch_controller");
  EXPECT_FALSE(hand->leftController.buttons.mailbox.reading().connected);
  right() = {};
  take();
  EXPECT_FALSE(hand->rightController.buttons.mailbox.reading().connected);
}

TEST_F(ControllerLinkTest, WhatIsHeldIsSaidWithThePlace) {
  const auto held = [this](ControllerButton button) {
    take();
    return (hand->rightController.place.reading().held >> static_cast<unsigned>(button) & 1U) != 0U;
  };
  right().pressed[static_cast<std::size_t>(ControllerButton::Upper)] = true;
  EXPECT_TRUE(held(ControllerButton::Upper));
  EXPECT_TRUE(held(ControllerButton::Upper));
  EXPECT_FALSE(held(ControllerButton::Trigger));
  right().pressed = {};
  right().trigger = 1.0;
  EXPECT_TRUE(held(ControllerButton::Trigger));
  EXPECT_FALSE(held(ControllerButton::Upper));
}

TEST_F(ControllerLinkTest, AButtonThatIsHeldIsPressedOnce) {
  for (const bool down : {false, true, true, false, true}) {
    right().pressed[static_cast<std::size_t>(ControllerButton::Menu)] = down;
    take();
  }
  EXPECT_EQ(presses(ControllerButton::Menu), 2U);
}

TEST_F(ControllerLinkTest, ATriggerThatTremblesIsPressedOnce) {
  for (const double trigger : {0.0, 0.69, 0.71, 0.69, 0.71, 0.5, 1.0, 0.0}) {
    right().trigger = trigger;
    take();
  }
  EXPECT_EQ(presses(ControllerButton::Trigger), 1U);
}

TEST_F(ControllerLinkTest, WhenTheHeadsetIsLostTheHandIsOpenAndAway) {
  right().X_RG = Pose::identity();
  right().squeeze = 1.0;
  take();
  link.reset();
  EXPECT_FALSE(hand->rightController.place.reading().X_WG);
  EXPECT_EQ(hand->rightController.place.reading().squeeze, 0.0);
  EXPECT_FALSE(hand->rightController.buttons.mailbox.reading().connected);
}

TEST_F(ControllerLinkTest, WhatTheHandFeelsIsSaidUnlessItIsTooWeak) {
  hand->rightController.place.setFeedback({true, 0.3});
  hand->leftController.place.setFeedback({true, 0.5 * ControllerLink::kLeastPush});
  EXPECT_EQ(link->push(ControllerSide::Right), 0.3);
  EXPECT_EQ(link->push(ControllerSide::Left), 0.0);
}

}  // namespace
}  // namespace glissade
