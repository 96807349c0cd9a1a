// The real window with the runtime for tests, on a virtual display: see with_headset.sh.
#include <QTimer>

#include <cstdlib>
#include <random>

#include "tests/widgets/headset/window_with_headset.h"

namespace glissade {
namespace {

using namespace std::chrono_literals;

class PictureCounter : public QObject {
 public:
  PictureCounter() { sinceLast_.start(); }
  int pictures() const { return pictures_; }
  int longestGap() const { return static_cast<int>(longestGap_); }  ///< ms

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Paint) {
      ++pictures_;
      longestGap_ = std::max(longestGap_, sinceLast_.restart());
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  QElapsedTimer sinceLast_;
  int pictures_ = 0;
  qint64 longestGap_ = 0;
};

class HeadsetWindowTest : public test::WindowWithHeadset {
 protected:
  HeadsetWindowTest() : WindowWithHeadset("environment-1/scenario.json") {}

  /// What the window draws in some seconds in which it draws its scene as often as it can.
  void drawFor(int milliseconds, PictureCounter& counter) {
    bench().scene.widget()->installEventFilter(&counter);
    QTimer ticks;
    QObject::connect(&ticks, &QTimer::timeout, [&] { bench().scene.refresh(); });
    ticks.start(0);
    until([] { return false; }, milliseconds);
    bench().scene.widget()->removeEventFilter(&counter);
  }
};

TEST_F(HeadsetWindowTest, TheWindowGetsItsTurnsBesideTheHeadset) {
  PictureCounter alone;
  drawFor(4000, alone);
  headset().trigger();
  ASSERT_TRUE(isRunning());
  const int before = test::shownPictures();
  PictureCounter beside;
  drawFor(4000, beside);
  std::printf("alone %d pictures, longest gap %d ms; beside the headset %d and %d ms, and %d of the headset\n",
              alone.pictures(), alone.longestGap(), beside.pictures(), beside.longestGap(),
              test::shownPictures() - before);
  EXPECT_GT(8 * beside.pictures(), alone.pictures());
  EXPECT_GT(test::shownPictures(), before);
}

TEST_F(HeadsetWindowTest, TheActionStartsAndStopsItAndTheWindowDrawsBeside) {
  headset().trigger();
  ASSERT_TRUE(isRunning());
  EXPECT_TRUE(until([] { return test::shownPictures() > 3; }));
  EXPECT_FALSE(bench().scene.picture().isNull());
  headset().trigger();
  EXPECT_EQ(state(), HeadsetState::Off);
  EXPECT_TRUE(until([] { return test::heldHandles() == 0; }));
}

TEST_F(HeadsetWindowTest, TheWindowEndsWhileTheHeadsetIsShown) {
  headset().trigger();
  ASSERT_TRUE(isRunning());
}

class HeadsetLossesTest : public HeadsetWindowTest {
 protected:
  /// GLISSADE_HEADSET_LOSSES=1000 takes minutes.
  static int losses() {
    const char* wanted = std::getenv("GLISSADE_HEADSET_LOSSES");
    return wanted != nullptr ? std::atoi(wanted) : 100;
  }
  int number(int least, int most) { return std::uniform_int_distribution(least, most)(random_); }

  void lose() {
    ASSERT_TRUE(isRunning());
    const int sessions = test::madeSessions();
    switch (number(0, 9)) {
      case 0: test::stallOnce(std::chrono::milliseconds(number(1, 60))); return;
      case 1:
        test::leaveProgram();
        EXPECT_TRUE(until([this] { return !headset().isChecked(); }));
        headset().trigger();
        return;
      case 2:
        test::setWorn(false);
        until([] { return false; }, number(0, 20));
        test::setWorn(true);
        return;
      case 3:
      case 4:
      case 5: test::loseSession(); break;
      default: test::loseRuntime(); break;
    }
    EXPECT_TRUE(until([&] { return test::madeSessions() > sessions; }));
  }

 private:
  std::mt19937 random_{7};
};

/// The gaps are printed, and not judged: the machine may be busy.
TEST_F(HeadsetLossesTest, WindowRunAndPlanGoOnWhileTheHeadsetIsLostAgainAndAgain) {
  PictureCounter alone;
  drawFor(2000, alone);
  headset().trigger();
  ASSERT_TRUE(isRunning());
  bench().actions["run.start"]->trigger();
  PictureCounter beside;
  bench().scene.widget()->installEventFilter(&beside);
  QTimer ticks;
  QObject::connect(&ticks, &QTimer::timeout, [this] { bench().scene.refresh(); });
  ticks.start(0);
  for (int i = 0; i < losses() && !HasFailure(); ++i) {
    lose();
    until([] { return false; }, number(0, 30));
  }
  ticks.stop();
  std::printf("%d losses; longest gap of the window %d ms, %d ms without a headset\n", losses(), beside.longestGap(),
              alone.longestGap());
  EXPECT_GT(beside.pictures(), losses() / 10) << "the window goes on";
  EXPECT_TRUE(isRunning());
  EXPECT_TRUE(until([this] { return bench().session.snapshot()->path != nullptr; }, 60'000));
  EXPECT_TRUE(headset().isChecked());
}

/// GLISSADE_HEADSET_SCENARIO measures another scenario.
TEST_F(HeadsetWindowTest, APictureSaysWhatItCosts) {
  if (const char* file = std::getenv("GLISSADE_HEADSET_SCENARIO")) {
    ASSERT_EQ(window_->openScenario(QString::fromLocal8Bit(file), true), std::nullopt);
  }
  headset().trigger();
  ASSERT_TRUE(isRunning());
  const auto figures = [this] { return bench().scene.headset()->figures(); };
  ASSERT_TRUE(until([&] { return figures().drawSeconds > 0.0; }, 120'000));
  const HeadsetFigures eye = figures();
  std::printf("an eye: %d draw calls, %lld triangles, detail %d, %.2f ms to choose, %.2f ms in OpenGL\n", eye.drawCalls,
              static_cast<long long>(eye.triangles), eye.detailStep, 1e3 * eye.cullSeconds, 1e3 * eye.drawSeconds);
  EXPECT_GT(eye.drawCalls, 0);
  EXPECT_GT(eye.triangles, 0);
  EXPECT_GT(eye.cullSeconds, 0.0);
}

class HeadsetBeforeWindowTest : public test::WindowWithHeadset {
 protected:
  HeadsetBeforeWindowTest() : WindowWithHeadset("environment-1/scenario.json", test::Shown::Later) {}
};

TEST_F(HeadsetBeforeWindowTest, AHeadsetThatStartsBeforeTheFirstPictureOfTheWindow) {
  const auto showsMore = [this] {
    return until([before = test::shownPictures()] { return test::shownPictures() > before + 3; });
  };
  headset().trigger();
  ASSERT_TRUE(isRunning());
  EXPECT_TRUE(showsMore());
  window_->show();
  EXPECT_FALSE(bench().scene.picture().isNull());
  EXPECT_TRUE(showsMore());
}

}  // namespace
}  // namespace glissade
