#include "engine/operator/keyboard_device.h"

#include <gtest/gtest.h>

#include "tests/engine/operator/operator_support.h"

namespace glissade {
namespace {

class Keyboard : public testing::Test {
 protected:
  double moveFor(double seconds) {
    const double before = q.position.x();
    for (double t = 0.0; t < seconds - 1e-9; t += 0.01) q = device.advance(0.01, viewOf(q), kRoom);
    return q.position.x() - before;
  }
  void press(double x) { keys->set({{x, 0, 0}, Vector3::Zero()}); }

  std::shared_ptr<DeflectionMailbox> keys = std::make_shared<DeflectionMailbox>();
  KeyboardDevice device{keys};
  Pose q;
};

TEST_F(Keyboard, ATapIsASmallStepAndHoldingGetsFaster) {
  press(1.0);
  const double first = moveFor(0.05);
  moveFor(0.5);
  const double later = moveFor(0.05);
  EXPECT_GT(first, 0.0);
  EXPECT_GT(later, 4.0 * first);
  EXPECT_NEAR(later, 0.05, 1e-9);  // full deflection is 1 m/s
}

TEST_F(Keyboard, LettingGoIsRestAtOnce) {
  press(1.0);
  moveFor(0.5);
  press(0.0);
  EXPECT_EQ(moveFor(0.5), 0.0);
}

TEST_F(Keyboard, TheOtherWayStartsFromRest) {
  press(1.0);
  moveFor(0.5);
  press(-1.0);
  EXPECT_LT(moveFor(0.01), 0.0);
}

}  // namespace
}  // namespace glissade
