// The controllers of a headset with the runtime for tests, on a virtual display: see with_headset.sh.
#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "tests/widgets/headset/runtime/headset_script.h"
#include "tests/widgets/headset/window_target.h"
#include "widgets/openxr/openxr_headset.h"
#include "widgets/scene3d/scene_view.h"

namespace glissade {
namespace {

using namespace std::chrono_literals;
using test::ControllerMoment;

constexpr std::size_t kLeft = 0;
constexpr std::size_t kRight = 1;
const Pose kGrip{Vector3(0.2, 1.1, -0.3), Quaternion(Eigen::AngleAxisd(0.4, Vector3::UnitX()))};

ControllerMoment gripAt(const Pose& X_RG, double squeeze = 0.0) {
  ControllerMoment moment;
  moment.X_RG = X_RG;
  moment.squeeze = squeeze;
  return moment;
}

class OpenXrControllersTest : public testing::Test {
 protected:
  OpenXrControllersTest() {
    test::resetHeadset();
    window_.draw(view_);
    headset_->setPlacement(room_);
    headset_->setHands(hands_);
    headset_->start();
  }
  ~OpenXrControllersTest() override {
    headset_.reset();
    EXPECT_EQ(test::heldHandles(), 0);
    EXPECT_EQ(test::complaints(), std::vector<std::string>());
  }

  template <class Condition>
  static bool until(Condition condition) {
    const auto end = std::chrono::steady_clock::now() + 20s;
    while (std::chrono::steady_clock::now() < end) {
      if (condition()) return true;
      std::this_thread::sleep_for(1ms);
    }
    return false;
  }
  ControllerReading right() const { return hands_->rightController.place.reading(); }
  bool isTracked() const {
    return until([this] { return right().X_WG.has_value(); });
  }
  std::uint32_t presses(ControllerButton button) const {
    return hands_->rightController.buttons.mailbox.reading().presses[static_cast<std::size_t>(button)];
  }

  HandInputsPtr hands_ = std::make_shared<HandInputs>();
  test::WindowTarget window_{64, 64};
  SceneView view_;
  RoomPlacement room_ = placeRoom(Box3(Vector3(0, 0, 0), Vector3(3, 3, 3)), ProductSize::OnTable);
  std::unique_ptr<Headset> headset_ = makeHeadset(view_);
};

TEST_F(OpenXrControllersTest, WhereTheHandIsInTheRoomIsSaidInTheWorld) {
  test::setController(kRight, gripAt(kGrip, 0.6));
  ASSERT_TRUE(isTracked());
  const ControllerReading reading = right();
  const Pose expected = inWorld(room_, kGrip);
  ASSERT_TRUE(reading.X_WG && reading.X_WA);
  EXPECT_LT((reading.X_WG->position - expected.position).norm(), 1e-5);
  EXPECT_LT(angleBetween(reading.X_WG->orientation, expected.orientation), 1e-3);
  EXPECT_NEAR(reading.squeeze, 0.6, 1e-6);
  EXPECT_EQ(reading.scale, room_.scale);
  EXPECT_EQ(hands_->rightController.buttons.mailbox.reading().name, "oculus/touch_controller");
  EXPECT_FALSE(hands_->leftController.buttons.mailbox.reading().connected);
}

TEST_F(OpenXrControllersTest, ButtonsOfEachHandAreCounted) {
  test::setController(kLeft, gripAt(kGrip));
  test::setController(kRight, gripAt(kGrip));
  ASSERT_TRUE(isTracked());
  ControllerMoment menu = gripAt(kGrip);
  menu.pressed = "/input/b/click";
  ControllerMoment trigger = gripAt(kGrip);
  trigger.trigger = 1.0;
  test::playController(kRight, {menu, gripAt(kGrip), trigger, gripAt(kGrip), menu, gripAt(kGrip)});
  ASSERT_TRUE(until([] { return test::hasPlayed(kRight); }));
  EXPECT_TRUE(until([this] { return presses(ControllerButton::Menu) == 2; }));
  EXPECT_EQ(presses(ControllerButton::Trigger), 1U);
  EXPECT_EQ(hands_->leftController.buttons.mailbox.reading().presses[1], 0U);
}

TEST_F(OpenXrControllersTest, AControllerThatIsNotTrackedHasNoPlace) {
  test::setController(kRight, gripAt(kGrip, 0.9));
  ASSERT_TRUE(isTracked());
  ControllerMoment hidden = gripAt(kGrip, 0.9);
  hidden.isTracked = false;
  test::setController(kRight, hidden);
  ASSERT_TRUE(until([this] { return !right().X_WG; }));
  EXPECT_NEAR(right().squeeze, 0.9, 1e-6);
  EXPECT_TRUE(hands_->rightController.buttons.mailbox.reading().connected);
}

TEST_F(OpenXrControllersTest, APushIsFeltByThatHandWithItsStrength) {
  test::setController(kRight, gripAt(kGrip));
  ASSERT_TRUE(isTracked());
  hands_->rightController.place.setFeedback({true, 0.25});
  std::vector<double> pulses;
  ASSERT_TRUE(until([&pulses] {
    pulses = test::takePulses(kRight);
    return !pulses.empty();
  }));
  EXPECT_NEAR(pulses.front(), 0.25, 1e-6);
  EXPECT_TRUE(test::takePulses(kLeft).empty());
  hands_->rightController.place.setFeedback({true, 0.0});
  const int read = test::readControllers();
  ASSERT_TRUE(until([read] { return test::readControllers() > read + 1; }));
  test::takePulses(kRight);
  ASSERT_TRUE(until([read] { return test::readControllers() > read + 4; }));
  EXPECT_TRUE(test::takePulses(kRight).empty());
}

TEST_F(OpenXrControllersTest, TheOtherHandPullsTheWorld) {
  test::setController(kLeft, gripAt(kGrip));
  test::setController(kRight, gripAt(kGrip));
  ASSERT_TRUE(isTracked());
  const Vector3 before = right().X_WG->position;
  const Pose pulled = Pose::translation({0.2, 0.0, 0.0}) * kGrip;
  test::playController(kLeft, {gripAt(kGrip, 1.0), gripAt(pulled, 1.0), gripAt(pulled), gripAt(kGrip)});
  ASSERT_TRUE(until([] { return test::hasPlayed(kLeft); }));
  const Vector3 expected = before - Vector3(0.2 / room_.scale, 0.0, 0.0);
  EXPECT_TRUE(until([&] { return right().X_WG && (right().X_WG->position - expected).norm() < 1e-4; }));
  headset_->setPlacement(room_);
  EXPECT_TRUE(until([&] { return right().X_WG && (right().X_WG->position - before).norm() < 1e-4; }))
      << "where the window places the person";
}

TEST_F(OpenXrControllersTest, LostWithTheSessionTheyComeBackWithIt) {
  test::setController(kRight, gripAt(kGrip, 0.9));
  ASSERT_TRUE(isTracked());
  for (const auto lose : {test::loseSession, test::loseRuntime}) {
    const int sessions = test::madeSessions();
    lose();
    ASSERT_TRUE(until([sessions] { return test::madeSessions() > sessions; }));
    ASSERT_TRUE(isTracked());
  }
  headset_->stop();
  EXPECT_TRUE(until([this] { return !right().X_WG && right().squeeze == 0.0; }));
  EXPECT_FALSE(hands_->rightController.buttons.mailbox.reading().connected);
}

}  // namespace
}  // namespace glissade
