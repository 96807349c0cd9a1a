#include "widgets/devices/calibration_dialog.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QPushButton>
#include <QTemporaryDir>

#include <limits>

#include "app/window/window_actions.h"

namespace glissade {
namespace {

class Calibration : public testing::Test {
 protected:
  Calibration() { hand->mouse6d.mailbox.connect("SpaceNavigator"); }

  DeviceShaping mouse() const { return hand->mouse6d.shaping.get(); }
  /// The shaping that a restarted program would read.
  DeviceShaping kept() const { return DeviceSettings(file).shaping(hand->mouse6d); }
  template <typename Widget>
  Widget* named(const char* name) const {
    return dialog.findChild<Widget*>(QLatin1String(name));
  }

  QTemporaryDir folder;
  QString file = folder.filePath(QStringLiteral("devices.ini"));
  HandInputsPtr hand = std::make_shared<HandInputs>();
  ActionCatalogue actions{windowActions(), nullptr};
  DeviceSettings settings{file};
  CalibrationDialog dialog{hand, settings, actions, nullptr};
};

TEST_F(Calibration, ADragCountsWhileItLastsAndIsKept) {
  auto* deadZone = dialog.findChildren<QSlider*>().front();
  for (const int position : {10, 20, 30}) {
    deadZone->setValue(position);
    EXPECT_NEAR(mouse().axes[0].deadZone, position / 100.0, 1e-9);
  }
  EXPECT_EQ(kept(), mouse());
  EXPECT_FALSE(kept() == standardShaping(InputKind::Mouse6D));
}

TEST_F(Calibration, EveryDeviceHasItsOwn) {
  dialog.findChildren<QSlider*>().front()->setValue(30);
  hand->mouse6d.mailbox.connect("SpaceMouse Pro");
  EXPECT_EQ(kept(), standardShaping(InputKind::Mouse6D));
  hand->mouse6d.mailbox.connect("SpaceNavigator");
  EXPECT_NEAR(kept().axes[0].deadZone, 0.3, 1e-9);
}

TEST_F(Calibration, PresetsAreTakenWholeAndResetIsTheStandard) {
  const auto presets = shapingPresets(InputKind::Mouse6D);
  auto* box = named<QComboBox>("preset");
  for (std::size_t i = 0; i < presets.size(); ++i) {
    box->setCurrentIndex(static_cast<int>(i));
    emit box->activated(static_cast<int>(i));
    EXPECT_EQ(mouse(), presets[i].shaping) << presets[i].id;
    EXPECT_EQ(kept(), presets[i].shaping) << presets[i].id;
    EXPECT_EQ(box->currentIndex(), static_cast<int>(i));
  }
  dialog.findChild<QPushButton*>()->click();
  EXPECT_EQ(mouse(), standardShaping(InputKind::Mouse6D));
  EXPECT_EQ(kept(), mouse());
}

TEST_F(Calibration, TheBarsFollowTheDeviceAndTheStateIsSaid) {
  hand->mouse6d.mailbox.setAxes({1.0, 0, -0.5, 0, 0, 0});
  dialog.refresh();
  const auto bars = dialog.findChildren<AxisBar*>();
  ASSERT_EQ(bars.size(), 6);
  EXPECT_EQ(bars[0]->shaped(), 1.0);
  EXPECT_LT(bars[2]->shaped(), -0.3);
  EXPECT_TRUE(named<QLabel>("device-state")->text().contains(QStringLiteral("SpaceNavigator")));
  hand->mouse6d.mailbox.disconnect();
  dialog.refresh();
  EXPECT_EQ(bars[0]->shaped(), 0.0);
  EXPECT_FALSE(named<QLabel>("device-state")->text().contains(QStringLiteral("SpaceNavigator")));
}

TEST_F(Calibration, ButtonsHaveActionsOfTheCatalogue) {
  EXPECT_EQ(settings.action(hand->mouse6d, 0), QStringLiteral("operator.camera"));
  EXPECT_EQ(settings.action(hand->mouse6d, 1), QStringLiteral("view.fit"));
  EXPECT_EQ(settings.action(hand->mouse6d, 2), QString());
  dialog.showButton(hand->mouse6d, 2);
  auto* action = named<QComboBox>("button-action");
  const int start = action->findData(QStringLiteral("run.start"));
  ASSERT_GT(start, 0);
  action->setCurrentIndex(start);
  emit action->activated(start);
  EXPECT_EQ(DeviceSettings(file).action(hand->mouse6d, 2), QStringLiteral("run.start"));
}

TEST_F(Calibration, AControllerHasButtonsWithNamesAndNoAxes) {
  auto* device = named<QComboBox>("device");
  for (HandInput* controller : {&hand->leftController.buttons, &hand->rightController.buttons}) {
    device->setCurrentIndex(controller->kind == InputKind::LeftController ? 3 : 4);
    EXPECT_FALSE(named<QComboBox>("preset")->isEnabled());
    EXPECT_FALSE(dialog.findChildren<QSlider*>().front()->isEnabled());
    dialog.showButton(*controller, 1);
    const QString expected =
        controller->kind == InputKind::LeftController ? QStringLiteral("run.stop") : QStringLiteral("run.start");
    EXPECT_EQ(named<QComboBox>("button-action")->currentData().toString(), expected);
  }
  // Two controllers of the same kind have separate actions.
  for (ControllerInput* controller : hand->controllers()) controller->buttons.mailbox.connect("valve/index_controller");
  settings.setAction(hand->leftController.buttons, 1, QStringLiteral("path.play"));
  EXPECT_EQ(settings.action(hand->leftController.buttons, 1), QStringLiteral("path.play"));
  EXPECT_EQ(settings.action(hand->rightController.buttons, 1), QStringLiteral("run.start"));
  device->setCurrentIndex(0);
  EXPECT_TRUE(dialog.findChildren<QSlider*>().front()->isEnabled());
}

TEST_F(Calibration, EveryEditorIsReachedByKeysAndThePageFitsSmallScreens) {
  for (QWidget* widget : dialog.findChildren<QWidget*>()) {
    const bool editor =
        qobject_cast<QSlider*>(widget) || qobject_cast<QComboBox*>(widget) || qobject_cast<QAbstractButton*>(widget);
    EXPECT_TRUE(!editor || (widget->focusPolicy() & Qt::TabFocus)) << widget->metaObject()->className();
  }
  EXPECT_LE(dialog.minimumSizeHint().width(), 1200);
  EXPECT_LE(dialog.minimumSizeHint().height(), 640);
}

TEST(DeviceSettings, WhatAFileHoldsOutOfRangeIsBroughtBack) {
  QTemporaryDir folder;
  const QString name = folder.filePath(QStringLiteral("devices.ini"));
  QFile file(name);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("[Keyboard]\naxis-0-gain=1e99\naxis-0-source=77\naxis-1-gain=lots\naxis-2-dead-zone=nan\nframe=upside\n");
  file.close();
  const HandInputs hand;
  const DeviceShaping shaping = DeviceSettings(name).shaping(hand.keyboard);
  EXPECT_EQ(shaping.axes[0].gain, kGainRange.highest);
  EXPECT_EQ(shaping.axes[0].source, 0U);
  EXPECT_EQ(shaping.axes[1].gain, 1.0);
  EXPECT_GE(shaping.axes[2].deadZone, 0.0);
  EXPECT_EQ(shaping.frame, MotionFrame::View);
}

}  // namespace
}  // namespace glissade
