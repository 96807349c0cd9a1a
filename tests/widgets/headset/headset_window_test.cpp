// The real window with the runtime for tests, on a virtual display: see with_headset.sh.
#include <QTimer>

#include <cstdlib>
#include <random>

#include "tests/widgets/headset/window_with_headset.h"

namespace glissade {
namespace {

using namespace std::chrono_literals;

/// Counts the pictures of a widget between begin() and end(), and measures the longest time without one.
class PictureCounter : public QObject {
 public:
  explicit PictureCounter(QWidget& counted) : counted_(counted) {}
  int pictures() const { return pictures_; }
  int longestGap() const { return static_cast<int>(longestGap_); }  ///< ms
  qint64 counted() const { return milliseconds_; }

  void begin() {
    sinceLast_.start();
    sinceBegin_.start();
    counted_.installEventFilter(this);
  }
  void end() {
    counted_.removeEventFilter(this);
    longestGap_ = std::max(longestGap_, sinceLast_.elapsed());
    milliseconds_ += sinceBegin_.elapsed();
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Paint) {
      ++pictures_;
      longestGap_ = std::max(longestGap_, sinceLast_.restart());
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  QWidget& counted_;
  QElapsedTimer sinceLast_;
  QElapsedTimer sinceBegin_;
  qint64 milliseconds_ = 0;
  int pictures_ = 0;
  qint64 longestGap_ = 0;
};

class HeadsetWindowTest : public test::WindowWithHeadset {
 protected:
  HeadsetWindowTest() : WindowWithHeadset("environment-1/scenario.json") {}

  /// Counts pictures during `work`, while the window draws its scene as often as it can.
  template <class Work>
  void drawDuring(PictureCounter& counter, Work work) {
    QTimer ticks;
    QObject::connect(&ticks, &QTimer::timeout, [&] { bench().scene.refresh(); });
    ticks.start(0);
    counter.begin();
    work();
    counter.end();
  }
  void drawFor(qint64 milliseconds, PictureCounter& counter) {
    drawDuring(counter, [&] { until([] { return false; }, static_cast<int>(milliseconds)); });
  }
  QWidget& scene() { return *bench().scene.widget(); }
};

TEST_F(HeadsetWindowTest, TheWindowGetsItsTurnsBesideTheHeadset) {
  PictureCounter alone(scene());
  drawFor(4000, alone);
  headset().trigger();
  ASSERT_TRUE(isRunning());
  const int before = test::shownPictures();
  PictureCounter beside(scene());
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
  /// A run that has found a path is followed by a new run.
  HeadsetLossesTest() {
    bench().session.setDevice("expert");
    QObject::connect(&bench().session, &SessionBridge::snapshotChanged, &again_, [this](const SnapshotPtr& snapshot) {
      if (snapshot->path == nullptr || snapshot->run == run_) return;
      run_ = snapshot->run;
      ++runs_;
      again_.start(0);
    });
    QObject::connect(&again_, &QTimer::timeout, [this] { bench().actions["run.start"]->trigger(); });
    again_.setSingleShot(true);
    again_.start(0);
  }

  /// Number of losses; GLISSADE_HEADSET_LOSSES=1000 takes minutes.
  static int losses() {
    const char* wanted = std::getenv("GLISSADE_HEADSET_LOSSES");
    return wanted != nullptr ? std::atoi(wanted) : 100;
  }
  /// Waits until a run has found a path, at most a minute: a run in real time can take longer.
  void plan() {
    until([before = runs_, this] { return runs_ > before; }, 60'000);
  }
  /// True once the planner has made another step.
  bool runGoesOn() {
    const SnapshotPtr before = bench().session.snapshot();
    return until([&] {
      const SnapshotPtr now = bench().session.snapshot();
      return now->run > before->run || (now->run == before->run && now->counts.steps > before->counts.steps);
    });
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

  int runs_ = 0;  ///< runs that have found a path

 private:
  std::mt19937 random_{7};
  std::uint64_t run_ = 0;  ///< the last run with a path
  QTimer again_;
};

/// Losses alternate with times of equal length without a headset, during one run after the other, so that both have the
/// same machine and the same work. Before, window and headset draw everything once, because software drawing takes
/// seconds to compile it. The gaps are printed, and not judged, because the machine may be busy.
TEST_F(HeadsetLossesTest, WindowRunAndPlanGoOnWhileTheHeadsetIsLostAgainAndAgain) {
  constexpr int kTogether = 20;
  PictureCounter first(scene());
  drawDuring(first, [this] { plan(); });
  PictureCounter firstBeside(scene());
  headset().trigger();
  drawDuring(firstBeside, [this] {
    plan();
    EXPECT_TRUE(until([before = test::shownPictures()] { return test::shownPictures() > before + 10; }));
  });
  headset().trigger();
  PictureCounter alone(scene());
  PictureCounter beside(scene());
  for (int done = 0; done < losses() && !HasFailure(); done += kTogether) {
    const qint64 before = beside.counted();
    headset().trigger();
    drawDuring(beside, [this] {
      for (int i = 0; i < kTogether && !HasFailure(); ++i) {
        lose();
        until([] { return false; }, number(0, 30));
      }
    });
    EXPECT_TRUE(isRunning());
    headset().trigger();
    drawFor(beside.counted() - before, alone);
  }
  std::printf("longest gap of the window: %d ms in its first run, %d ms in the first beside the headset\n",
              first.longestGap(), firstBeside.longestGap());
  std::printf(
      "%d losses in %lld ms; longest gap of the window %d ms (%d pictures), %d ms (%d) without a headset; %d runs\n",
      losses(), static_cast<long long>(beside.counted()), beside.longestGap(), beside.pictures(), alone.longestGap(),
      alone.pictures(), runs_);
  EXPECT_GT(beside.pictures(), losses() / 10) << "the window goes on";
  EXPECT_GT(runs_, 0);
  EXPECT_TRUE(runGoesOn());
  headset().trigger();
  EXPECT_TRUE(isRunning());
}

/// Prints the costs of a picture; GLISSADE_HEADSET_SCENARIO names another scenario.
TEST_F(HeadsetWindowTest, APictureSaysWhatItCosts) {
  if (const char* file = std::getenv("GLISSADE_HEADSET_SCENARIO")) {
    ASSERT_EQ(window_->openScenario(QString::fromLocal8Bit(file), true), std::nullopt);
  }
  headset().trigger();
  ASSERT_TRUE(isRunning());
  const auto figures = [this] { return bench().scene.headset()->figures(); };
  // Small bodies are drawn together once they have not moved for some pictures.
  ASSERT_TRUE(until([before = test::shownPictures()] { return test::shownPictures() > before + 150; }, 120'000));
  ASSERT_TRUE(until([&] { return figures().drawSeconds > 0.0; }));
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
