// The real window with the runtime for tests, on a virtual display: see with_headset.sh.
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QThread>

#include "app/window/main_window.h"
#include "tests/engine/support/directories.h"
#include "tests/widgets/headset/runtime/headset_script.h"

namespace glissade::test {

enum class Shown { AtOnce, Later };

/// Opens a sample in the window; the headset is off.
class WindowWithHeadset : public testing::Test {
 protected:
  explicit WindowWithHeadset(const char* sample, Shown shown = Shown::AtOnce)
      : window_(std::make_unique<MainWindow>(makeOnscreenSceneWidget, SessionClock::RealTime)) {
    resetHeadset();
    window_->setBatch(true);
    window_->resize(900, 600);
    const QString file =
        QString::fromStdString(sourceDirectory()) + QStringLiteral("/samples/") + QLatin1String(sample);
    EXPECT_EQ(window_->openScenario(file, true), std::nullopt);
    if (shown == Shown::AtOnce) window_->show();
  }
  ~WindowWithHeadset() override {
    window_.reset();
    EXPECT_EQ(heldHandles(), 0);
    EXPECT_EQ(complaints(), std::vector<std::string>());
  }

  const Workbench& bench() { return window_->workbench(); }
  HeadsetState state() { return bench().scene.headset()->status().state; }
  QAction& headset() { return *bench().actions["view.headset"]; }
  template <class Condition>
  bool until(Condition condition, int longest = 30'000) {
    QElapsedTimer since;
    since.start();
    while (since.elapsed() < longest) {
      if (condition()) return true;
      QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
      QThread::msleep(1);
    }
    return false;
  }
  bool isRunning() {
    return until([this] { return state() == HeadsetState::Running; });
  }

  std::unique_ptr<MainWindow> window_;
};

}  // namespace glissade::test
