// The real window with the runtime for tests, on a virtual display: see with_headset.sh.
#include <QTimer>

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

TEST_F(HeadsetWindowTest, WindowRunAndPlanGoOnWhileTheHeadsetIsLostAgainAndAgain) {
  headset().trigger();
  ASSERT_TRUE(isRunning());
  bench().actions["run.start"]->trigger();
  std::mt19937 random(7);
  constexpr int kLosses = 100;
  for (int i = 0; i < kLosses; ++i) {
    const int sessions = test::madeSessions();
    if (random() % 2 == 0) {
      test::loseSession();
    } else {
      test::loseRuntime();
    }
    ASSERT_TRUE(until([&] { return test::madeSessions() > sessions; })) << i;
    const int wait = static_cast<int>(random() % 30);
    until([] { return false; }, wait);
  }
  EXPECT_TRUE(isRunning());
  EXPECT_TRUE(until([this] { return bench().session.snapshot()->path != nullptr; }, 60'000));
  EXPECT_TRUE(headset().isChecked());
}

}  // namespace
}  // namespace glissade
