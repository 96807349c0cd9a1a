#include "engine/operator/shaped_device.h"

#include <gtest/gtest.h>

#include <thread>

#include "tests/engine/operator/operator_support.h"

namespace glissade {
namespace {

class Shaped : public testing::Test {
 protected:
  static double moveFor(ShapedDevice& device, double seconds) {
    Pose q;
    for (double t = 0.0; t < seconds - 1e-9; t += 0.01) q = device.advance(0.01, viewOf(q), kRoom);
    return q.position.x();
  }
  static void deflect(HandInput& input, double x) { input.mailbox.setAxes({x, 0, 0, 0, 0, 0}); }

  HandInputsPtr hand = std::make_shared<HandInputs>();
  ShapedDevice keys{hand, hand->keyboard};
  ShapedDevice pad{hand, hand->gamepad};
};

TEST_F(Shaped, ATapOfAKeyIsASmallStepAndHoldingGetsFaster) {
  deflect(hand->keyboard, 1.0);
  const double first = moveFor(keys, 0.05);
  moveFor(keys, 0.5);
  const double later = moveFor(keys, 0.05);
  EXPECT_GT(first, 0.0);
  EXPECT_GT(later, 4.0 * first);
  EXPECT_NEAR(later, 0.05, 1e-9);  // full deflection is 1 m/s
}

TEST_F(Shaped, LettingGoIsRestAtOnce) {
  deflect(hand->keyboard, 1.0);
  moveFor(keys, 0.5);
  deflect(hand->keyboard, 0.0);
  EXPECT_EQ(moveFor(keys, 0.5), 0.0);
}

TEST_F(Shaped, TheOtherWayStartsFromRest) {
  deflect(hand->keyboard, 1.0);
  moveFor(keys, 0.5);
  deflect(hand->keyboard, -1.0);
  EXPECT_LT(moveFor(keys, 0.01), 0.0);
}

TEST_F(Shaped, AnAnalogueDeviceAnswersAtOnceAndLiveChangesOfItsShapingCount) {
  hand->gamepad.mailbox.connect("pad");
  deflect(hand->gamepad, 1.0);
  EXPECT_NEAR(moveFor(pad, 0.01), 0.01, 1e-12);
  DeviceShaping shaping = hand->gamepad.shaping.get();
  shaping.axes[0].inverted = true;
  shaping.linearSpeed = 0.5;
  hand->gamepad.shaping.set(shaping);
  EXPECT_NEAR(moveFor(pad, 0.01), -0.005, 1e-12);
}

TEST_F(Shaped, TheCameraOrAnotherWindowTakesItAway) {
  hand->gamepad.mailbox.connect("pad");
  deflect(hand->gamepad, 1.0);
  hand->target = SteeringTarget::Camera;
  EXPECT_EQ(moveFor(pad, 0.1), 0.0);
  hand->target = SteeringTarget::Object;
  hand->focused = false;
  EXPECT_EQ(moveFor(pad, 0.1), 0.0);
  hand->focused = true;
  EXPECT_GT(moveFor(pad, 0.1), 0.0);
}

TEST_F(Shaped, AnUnpluggedDeviceIsAtRest) {
  hand->gamepad.mailbox.connect("pad");
  deflect(hand->gamepad, 1.0);
  hand->gamepad.mailbox.disconnect();
  EXPECT_EQ(moveFor(pad, 0.1), 0.0);
  EXPECT_FALSE(pad.connected());
}

TEST(InputMailbox, SilenceIsRestOnlyWhereDevicesRepeatThemselves) {
  InputMailbox repeating(std::chrono::milliseconds(1));
  InputMailbox changesOnly;
  for (InputMailbox* mailbox : {&repeating, &changesOnly}) {
    mailbox->connect("device");
    mailbox->setAxes({1, 0, 0, 0, 0, 0});
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_TRUE(repeating.reading().atRest());
  EXPECT_FALSE(changesOnly.reading().atRest());
}

TEST(InputMailbox, CountsPressesAndTellsOfEveryChange) {
  InputMailbox mailbox;
  int notified = 0;
  mailbox.setListener([&] { ++notified; });
  mailbox.connect("device");
  mailbox.press(1);
  mailbox.press(1);
  mailbox.press(99);  // a higher number than are counted
  EXPECT_EQ(mailbox.reading().presses[1], 2U);
  mailbox.disconnect();
  mailbox.disconnect();
  EXPECT_EQ(notified, 4);
  mailbox.setListener({});
  mailbox.press(0);
  EXPECT_EQ(notified, 4);
}

}  // namespace
}  // namespace glissade
