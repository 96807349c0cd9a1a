// View > Headset in the whole window, with a headset whose answers the test sets.
#include "widgets/headset/headset_controller.h"

#include <QStatusBar>
#include <QToolButton>
#include <numbers>

#include "tests/app/whole_window.h"
#include "tests/widgets/headset/said_headset.h"

namespace glissade {
namespace {

class HeadsetControllerTest : public testing::Test {
 protected:
  HeadsetControllerTest()
      : window_([this](QWidget*) { return std::make_unique<test::UnseenScene>(&headset_); }, SessionClock::Lockstep) {
    window_.setBatch(true);
    EXPECT_EQ(window_.openScenario(test::WholeWindowTest::sample("environment-1"), true), std::nullopt);
  }

  QAction& action(const char* id) { return *window_.workbench().actions[QLatin1String(id)]; }
  QLabel& sign() { return *window_.findChild<QLabel*>(QStringLiteral("headset-sign")); }
  bool hasSign() { return !sign().isHidden(); }

  test::SaidHeadset headset_;
  MainWindow window_;
};

TEST_F(HeadsetControllerTest, TheActionStartsAndStopsIt) {
  action("view.headset").trigger();
  EXPECT_EQ(headset_.starts(), 1);
  action("view.headset").trigger();
  EXPECT_EQ(headset_.stops(), 1);
}

TEST_F(HeadsetControllerTest, WhatIsMissingIsSaidUntilPicturesAreShown) {
  action("view.headset").trigger();
  headset_.say({HeadsetState::Searching, HeadsetTrouble::NoRuntime, "", ""});
  EXPECT_TRUE(hasSign());
  EXPECT_TRUE(sign().text().contains(QStringLiteral("OpenXR")));
  headset_.say({HeadsetState::Idle, HeadsetTrouble::None, "", "Goggles"});
  EXPECT_TRUE(sign().text().contains(QStringLiteral("Goggles")));
  headset_.say({HeadsetState::Running, HeadsetTrouble::None, "", "Goggles"});
  EXPECT_FALSE(hasSign());
  EXPECT_TRUE(action("view.headset").isChecked());
}

TEST_F(HeadsetControllerTest, ARefusedCallAndAStallAreSaidWhilePicturesAreShown) {
  action("view.headset").trigger();
  HeadsetStatus status{HeadsetState::Running, HeadsetTrouble::None, "", "Goggles"};
  headset_.say(status);
  status.refused = "xrApplyHapticFeedback -19";
  headset_.say(status);
  EXPECT_TRUE(sign().text().contains(QStringLiteral("xrApplyHapticFeedback -19")));
  status.stalls = true;
  headset_.say(status);
  EXPECT_TRUE(sign().text().contains(QStringLiteral("seconds")));
  headset_.say({HeadsetState::Off, HeadsetTrouble::None, "", ""});
  EXPECT_FALSE(hasSign());
  EXPECT_FALSE(window_.statusBar()->currentMessage().contains(QStringLiteral("Goggles")));
}

TEST_F(HeadsetControllerTest, EveryTroubleHasWordsOfItsOwn) {
  QStringList said;
  for (const auto trouble :
       {HeadsetTrouble::None, HeadsetTrouble::NoDisplay, HeadsetTrouble::NoRuntime, HeadsetTrouble::NoOpenGl,
        HeadsetTrouble::NoHeadset, HeadsetTrouble::SessionLost, HeadsetTrouble::RuntimeLost, HeadsetTrouble::Failed}) {
    said << HeadsetController::textOf({HeadsetState::Searching, trouble, "xrWaitFrame -1", ""});
  }
  EXPECT_EQ(said.removeDuplicates(), 0);
  EXPECT_TRUE(said.last().contains(QStringLiteral("xrWaitFrame -1")));
  EXPECT_FALSE(said.contains(QString()));
}

TEST_F(HeadsetControllerTest, WhatAPictureCostsIsSaid) {
  action("headset.figures").trigger();
  const QString before = window_.statusBar()->currentMessage();
  headset_.setFigures({2, 64, 1224, 1.2e-4, 1.18e-2});
  action("headset.figures").trigger();
  const QString text = window_.statusBar()->currentMessage();
  EXPECT_NE(text, before);
  for (const char* part : {"64", "1,224", "0.12", "11.80", "2"})
    EXPECT_TRUE(text.contains(QLatin1String(part))) << part;
}

TEST_F(HeadsetControllerTest, WhoLeavesItFindsTheActionOffAndStartsItAgain) {
  action("view.headset").trigger();
  headset_.say({HeadsetState::Running, HeadsetTrouble::None, "", ""});
  headset_.say({HeadsetState::Left, HeadsetTrouble::None, "", ""});
  EXPECT_FALSE(action("view.headset").isChecked());
  EXPECT_FALSE(hasSign());
  EXPECT_EQ(headset_.stops(), 0);
  action("view.headset").trigger();
  EXPECT_EQ(headset_.starts(), 2);
}

TEST_F(HeadsetControllerTest, TheProductIsAtTrueScaleOrOnATable) {
  action("view.headset").trigger();
  EXPECT_EQ(headset_.room().scale, 1.0);
  action("headset.on-table").trigger();
  EXPECT_LT(headset_.room().scale, 1.0);
  EXPECT_EQ(window_.openScenario(test::WholeWindowTest::sample("teaching"), true), std::nullopt);
  const Box3 product = window_.workbench().scene.view().extent();
  EXPECT_DOUBLE_EQ(headset_.room().scale * product.sizes().maxCoeff(), 0.6);
}

TEST_F(HeadsetControllerTest, APersonStandsWhereTheCameraOfANamedViewIs) {
  CameraController& camera = window_.workbench().scene.view().camera();
  const ScriptCommands& scripts = window_.workbench().scripts;
  CameraPose pose = camera.pose();
  pose.focus = {1.0, 2.0, 3.0};
  pose.R_WV = Quaternion(Eigen::AngleAxisd(std::numbers::pi / 2.0, Vector3::UnitX()));  // looks along y
  pose.distance = 4.0;
  camera.setPose(pose);
  EXPECT_TRUE(scripts.carryOut("save-view", {"Front"}).ok());
  action("view.headset").trigger();
  pose.R_WV = Quaternion::Identity();  // looks straight down
  camera.setPose(pose);
  EXPECT_TRUE(scripts.carryOut("save-view", {"Above"}).ok());
  for (const bool onTable : {false, true}) {
    if (onTable) action("headset.on-table").trigger();
    const double scale = headset_.room().scale;
    const auto standAt = [](const char* name) {
      for (QWidget* widget : QApplication::allWidgets()) {
        auto* button = qobject_cast<QToolButton*>(widget);
        const bool isOnPage = button != nullptr && button->window()->objectName() == QStringLiteral("headset-page");
        if (isOnPage && button->text() == QLatin1String(name)) button->click();
      }
    };
    const auto eye = [&] { return inWorld(headset_.room(), Pose::translation({0.0, 1.6, 0.0})).position; };
    const auto ahead = [this] { return Vector3(headset_.room().X_WR.orientation * -Vector3::UnitZ()); };
    standAt("Front");
    EXPECT_TRUE(eye().isApprox(Vector3(1.0, -2.0, 3.0), 1e-9)) << eye().transpose();
    EXPECT_TRUE(ahead().isApprox(Vector3::UnitY(), 1e-9)) << ahead().transpose();
    standAt("Above");
    EXPECT_TRUE(eye().isApprox(Vector3(1.0, 2.0, 7.0), 1e-9)) << eye().transpose();
    EXPECT_TRUE(ahead().isApprox(Vector3::UnitY(), 1e-9)) << ahead().transpose();
    EXPECT_EQ(headset_.room().scale, scale);
  }
}

TEST_F(HeadsetControllerTest, TheShareOfTheComputerFollowsTheGripThatHoldsTheObject) {
  SessionBridge& session = window_.workbench().session;
  const auto alpha = [&session] { return session.snapshot()->parameters[ParameterId::Alpha]; };
  const auto squeeze = [&](double share) {
    const Pose hand = session.snapshot()->device.q_device;
    for (int i = 0; i < 2; ++i) {  // one step grips, the next one reports the grip
      headset_.hands()->rightController.place.set({hand, hand, share, 1.0});
      session.advance(1);
      QCoreApplication::processEvents();
    }
  };
  session.post(command::SetParameter{ParameterId::Alpha, 0.6});
  session.post(command::Start{});
  squeeze(1.0);
  EXPECT_NEAR(alpha(), 0.1, 1e-9);
  squeeze(0.5);
  EXPECT_GT(alpha(), 0.1);
  EXPECT_LT(alpha(), 0.6);
  squeeze(0.0);
  EXPECT_NEAR(alpha(), 0.6, 1e-9);
  action("headset.grip-alpha").setChecked(false);
  squeeze(1.0);
  EXPECT_NEAR(alpha(), 0.6, 1e-9);
  action("headset.grip-alpha").setChecked(true);
  QCoreApplication::processEvents();
  EXPECT_NEAR(alpha(), 0.1, 1e-9) << "at once";
  squeeze(0.0);
}

TEST_F(HeadsetControllerTest, TheMainHandIsTheOneThatAPersonWants) {
  EXPECT_EQ(headset_.hands()->mainHand, ControllerSide::Right);
  action("headset.left-handed").setChecked(true);
  EXPECT_EQ(headset_.hands()->mainHand, ControllerSide::Left);
  action("headset.left-handed").setChecked(false);
  EXPECT_EQ(headset_.hands()->mainHand, ControllerSide::Right);
}

TEST_F(HeadsetControllerTest, MenusOfTheControllersStartAndStopARunWhateverWindowHasTheFocus) {
  HandInputs& hands = *headset_.hands();
  hands.focused = false;
  const auto press = [](ControllerInput& controller) {
    controller.buttons.mailbox.press(static_cast<std::size_t>(ControllerButton::Menu));
    QCoreApplication::processEvents();
  };
  press(hands.rightController);
  const auto& session = window_.workbench().session;
  EXPECT_TRUE(isRunning(*session.snapshot()));
  press(hands.leftController);
  EXPECT_FALSE(isRunning(*session.snapshot()));
}

TEST(HeadsetController, WithoutOpenXrItsActionsSayWhyTheyAreDisabled) {
  MainWindow window([](QWidget*) { return std::make_unique<test::UnseenScene>(); }, SessionClock::Lockstep);
  const QAction& action = *window.workbench().actions["view.headset"];
  EXPECT_FALSE(action.isEnabled());
  EXPECT_TRUE(action.toolTip().contains(QStringLiteral("OpenXR")));
}

}  // namespace
}  // namespace glissade
