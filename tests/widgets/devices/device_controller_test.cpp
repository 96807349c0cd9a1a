// The person's devices in a window in real time, with a daemon that works or fails.
#include "widgets/devices/device_controller.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <QApplication>
#include <QLabel>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QToolButton>

#include <functional>
#include <iostream>

#include "app/window/window_actions.h"
#include "tests/engine/operator/fake_spacenav_daemon.h"
#include "tests/widgets/scene3d/unseen_scene.h"
#include "widgets/scene3d/camera_controller.h"

namespace glissade {
namespace {

class Controller : public testing::Test {
 protected:
  Controller() {
    qputenv("SPNAV_SOCKET", socket.toUtf8());
    qputenv("XDG_CONFIG_HOME", folder.path().toUtf8());
    controller = std::make_unique<DeviceController>(bridge, actions, scene, &window);
    controller->addIndicators(bar);
  }
  ~Controller() override {
    controller.reset();
    qunsetenv("SPNAV_SOCKET");
    qunsetenv("XDG_CONFIG_HOME");
  }

  /// Runs the window's event loop until the condition holds, and remembers its longest pause.
  bool eventually(const std::function<bool()>& condition, int patience = 20000) {
    QElapsedTimer all;
    all.start();
    while (!condition() && all.elapsed() < patience) {
      QElapsedTimer turn;
      turn.start();
      QApplication::processEvents(QEventLoop::AllEvents, 5);
      longestTurn = std::max(longestTurn, turn.nsecsElapsed() / 1e6);
      ::usleep(1000);
    }
    return condition();
  }
  QString mouseState() const { return bar.findChild<QLabel*>(QStringLiteral("mouse-state"))->text(); }
  bool seen() const { return mouseState().contains(QStringLiteral("SpaceNavigator")); }

  QTemporaryDir folder;
  QString socket = folder.filePath(QStringLiteral("spnav.sock"));
  QWidget window;
  QStatusBar bar;
  ActionCatalogue actions{windowActions(), nullptr};
  SessionBridge bridge{SessionClock::RealTime};
  test::UnseenScene scene;
  std::unique_ptr<DeviceController> controller;
  double longestTurn = 0.0;
};

TEST_F(Controller, TheStateOfTheMouseIsShownAsItComesAndGoes) {
  EXPECT_FALSE(seen());
  auto daemon = std::make_unique<FakeSpacenavDaemon>(socket.toStdString());
  EXPECT_TRUE(eventually([&] { return seen(); }));
  daemon.reset();
  EXPECT_TRUE(eventually([&] { return !seen(); }));
}

TEST_F(Controller, AButtonOfThePuckSwitchesWhatItMovesAndThePuckThenMovesTheCamera) {
  FakeSpacenavDaemon daemon(socket.toStdString());
  ASSERT_TRUE(eventually([&] { return seen(); }));
  const auto* target = bar.findChild<QToolButton*>(QStringLiteral("steering-target"));
  const QString object = target->text();
  const Vector3 focus = scene.view().camera().focus();
  daemon.sendMotion(350, 0, 0);
  EXPECT_TRUE(eventually([&] { return !bridge.hand()->mouse6d.mailbox.reading().atRest(); }));
  EXPECT_EQ(scene.view().camera().focus(), focus);
  daemon.sendButton(0, true);
  daemon.sendButton(0, false);
  ASSERT_TRUE(eventually([&] { return bridge.hand()->target == SteeringTarget::Camera; }));
  EXPECT_NE(target->text(), object);
  EXPECT_TRUE(target->isChecked());
  daemon.sendMotion(350, 0, 0);
  EXPECT_TRUE(eventually([&] { return scene.view().camera().focus() != focus; }));
  daemon.sendButton(0, true);
  EXPECT_TRUE(eventually([&] { return bridge.hand()->target == SteeringTarget::Object; }));
}

TEST_F(Controller, NoDaemonHoldsTheWindow) {
  {
    FakeSpacenavDaemon silent(socket.toStdString(), {true, false});
    eventually([] { return false; }, 700);
  }
  {
    FakeSpacenavDaemon deaf(socket.toStdString(), {false, false});
    eventually([] { return false; }, 700);
  }
  FakeSpacenavDaemon daemon(socket.toStdString());
  ASSERT_TRUE(eventually([&] { return seen(); }));
  actions["operator.devices"]->trigger();
  const auto flood = [&daemon] {
    for (int i = 0; i < 200000; ++i) daemon.sendMotion(i % 350, 0, 0);
    daemon.sendBytes(std::vector<unsigned char>(333, 0xab));
  };
  std::thread flooding(flood);
  int turns = 0;
  eventually([&] { return ++turns > 100; });
  flooding.join();
  EXPECT_TRUE(eventually([&] { return !seen(); }));
  EXPECT_TRUE(eventually([&] { return seen(); }));
  std::cout << "longest turn of the window: " << longestTurn << " ms\n";
}

}  // namespace
}  // namespace glissade
