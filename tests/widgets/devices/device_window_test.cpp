// A script uses the devices: the steering target, buttons, the calibration page.
#include "tests/app/window_fixture.h"

namespace {

using namespace glissade::test;

class DeviceWindow : public WindowTest {
 protected:
  QString picture(const char* name) const { return folder.filePath(QLatin1String(name)); }
  double changed(const char* a, const char* b) const { return difference(QImage(picture(a)), QImage(picture(b))).mean; }
};

TEST_F(DeviceWindow, AMouseMovesTheObjectAndAButtonGivesItTheCamera) {
  const WindowResult outcome = run(QStringLiteral("sliding-plane"),
                                   QStringLiteral("screenshot %1/none.png\nplug mouse6d SpaceNavigator\n"
                                                  "expect-steering object\ndeflect mouse6d 0 1 0 0 0 0\nsteps 60\n"
                                                  "deflect mouse6d 0 0 0 0 0 0\nscreenshot %1/object.png\n"
                                                  "press mouse6d 0\nexpect-steering camera\nscreenshot %1/camera.png\n"
                                                  "deflect mouse6d 0 0 1 0 1 0\nsteps 60\nscreenshot %1/moved.png\n"
                                                  "deflect mouse6d 0 0 0 0 0 0\npress mouse6d 1\nsteps 60\n"
                                                  "action operator.camera\nexpect-steering object\n")
                                       .arg(folder.path()));
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
  EXPECT_GT(changed("none.png", "object.png"), 0.2);
  EXPECT_GT(changed("object.png", "camera.png"), 0.0);  // the status bar shows the target
  EXPECT_GT(changed("camera.png", "moved.png"), 1.0);
}

TEST_F(DeviceWindow, TheCalibrationPageShowsTheAxesLive) {
  const WindowResult outcome = run(QStringLiteral("environment-1"),
                                   QStringLiteral("plug mouse6d SpaceNavigator\naction operator.devices\n"
                                                  "screenshot %1/rest.png\ndeflect mouse6d 0.6 -0.3 0.9 0.03 0.2 -1\n"
                                                  "screenshot %1/live.png\nunplug mouse6d\nscreenshot %1/gone.png\n")
                                       .arg(folder.path()));
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
  EXPECT_GT(changed("rest.png", "live.png"), 0.2);
  EXPECT_GT(changed("live.png", "gone.png"), 0.2);
  expectLike(picture("live.png"), QStringLiteral("devices"));
}

/// A held key pushes the object against a wall. The object stays there, and the hand is drawn beside it.
TEST_F(DeviceWindow, KeysSteerInTheAxesThatAreChosenAndWallsStopTheObject) {
  const WindowResult outcome =
      run(QStringLiteral("environment-1"),
          QStringLiteral("select-operator hand\nselect-strategy interactive\nexpect-frame view\n"
                         "screenshot %1/view.png\nkey tap F\nexpect-frame world\naction operator.frame\n"
                         "expect-frame object\nscreenshot %1/object.png\nkey tap F\nexpect-frame view\n"
                         "action view.left\nkey press A\nsteps 200\nkey release A\n"
                         "key press Q\nsteps 200\nscreenshot %1/held.png\n"
                         "key release Q\nsteps 1\nscreenshot %1/released.png\n")
              .arg(folder.path()));
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
  EXPECT_GT(changed("view.png", "object.png"), 0.0) << "the status bar says which axes";
  EXPECT_GT(changed("held.png", "released.png"), 0.02) << "the hand is no longer ahead";
}

/// At alpha = 0 nothing is planned while the hand rests. Finish for me gives the run to the computer, and the settings
/// are as before when it has ended.
TEST_F(DeviceWindow, TheComputerFinishesARunByHandOnRequest) {
  const WindowResult outcome =
      run(QStringLiteral("sliding-plane"),
          QStringLiteral("select-operator hand\nselect-strategy by-hand\nset alpha 0\naction run.start\nsteps 500\n"
                         "expect planning\naction run.finish\nexpect-value alpha 1\nwait solved 100000\nsteps 1\n"
                         "expect-value alpha 0\n"));
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
}

/// Algorithm 1 at alpha = 1 would be a plain BiRRT: the strategy "auto" finishes the run, and the strategy is as before
/// when it has ended.
TEST_F(DeviceWindow, TheAutomaticPlannersFinishARunOfAlgorithm1) {
  const WindowResult outcome = run(
      QStringLiteral("sliding-plane"),
      QStringLiteral("select-operator hand\nselect-strategy contact-birrt\nset alpha 0\naction run.start\nsteps 50\n"
                     "expect planning\naction run.finish\nsteps 1\nexpect-strategy auto\nwait solved 100000\n"
                     "steps 1\nexpect-strategy contact-birrt\nexpect-value alpha 0\n"));
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
}

TEST_F(DeviceWindow, ScriptsAboutDevicesSayWhereTheyGoWrong) {
  for (const char* line : {"plug telepathy X", "deflect mouse6d 1 2 3 4 5 six", "press gamepad 99"}) {
    EXPECT_EQ(run(QStringLiteral("sliding-plane"), QString::fromLatin1(line)).exitCode, 3) << line;
  }
  EXPECT_EQ(run(QStringLiteral("sliding-plane"), QStringLiteral("expect-steering camera")).exitCode, 1);
}

}  // namespace
