#include "widgets/workbench/work_controller.h"

#include <gtest/gtest.h>

#include <QProgressBar>
#include <QThread>
#include <QtTest>
#include <atomic>

#include "app/window/window_actions.h"

namespace glissade {
namespace {

class Works : public testing::Test {
 protected:
  /// Work that runs until it is released or stopped.
  BackgroundTask::Work work(bool& delivered) {
    return [this, &delivered](const WorkWatch& watch) -> BackgroundTask::Delivery {
      while (!go && !watch.stop.stopRequested()) QThread::msleep(1);
      return [&delivered] { delivered = true; };
    };
  }

  void TearDown() override { go = true; }

  std::atomic<bool> go{false};
  bool first = false;
  bool second = false;
  bool third = false;
  QStatusBar bar;
  ActionCatalogue actions{windowActions(), nullptr};
  SessionBridge bridge{SessionClock::RealTime};
  WorkController works{bridge, actions, bar};
};

TEST_F(Works, TakeEachOthersPlace) {
  works.run(QStringLiteral("first"), work(first));
  works.run(QStringLiteral("second"), work(second));
  go = true;
  ASSERT_TRUE(QTest::qWaitFor([&] { return second; }));
  EXPECT_FALSE(first);
}

TEST_F(Works, OneThatTakesLongIsShownAndCancelledAgainAfterOthers) {
  const QObject film;
  const QObject planning;
  bool filmCancelled = false;
  works.beginOther(
      film, QStringLiteral("film"), [&] { filmCancelled = true; }, WorkController::Loss::Asked);
  works.beginOther(planning, QStringLiteral("planning"), [] {});
  EXPECT_EQ(works.endangered(), QStringLiteral("film"));
  QAction* cancel = actions[QStringLiteral("work.cancel")];
  cancel->trigger();
  EXPECT_FALSE(filmCancelled) << "the one that began last is cancelled";
  works.endOther(planning);
  EXPECT_TRUE(cancel->isEnabled());
  EXPECT_EQ(bar.findChild<QProgressBar*>()->accessibleName(), QStringLiteral("film"));
  cancel->trigger();
  EXPECT_TRUE(filmCancelled);
  works.endOther(film);
  EXPECT_FALSE(cancel->isEnabled());
  EXPECT_TRUE(works.endangered().isEmpty());
}

TEST_F(Works, WaitForOneThatIsToBeFinished) {
  works.runToEnd(QStringLiteral("first"), work(first));
  works.run(QStringLiteral("second"), work(second));
  works.run(QStringLiteral("third"), work(third));  // replaces the second one
  go = true;
  ASSERT_TRUE(QTest::qWaitFor([&] { return first && third; }));
  EXPECT_FALSE(second);
  EXPECT_FALSE(actions[QStringLiteral("work.cancel")]->isEnabled());
}

TEST_F(Works, OnlyTheUserEndsOneThatIsToBeFinished) {
  works.runToEnd(QStringLiteral("first"), work(first));
  works.cancel();
  QAction* cancel = actions[QStringLiteral("work.cancel")];
  EXPECT_TRUE(cancel->isEnabled());
  works.run(QStringLiteral("second"), work(second));
  cancel->trigger();
  go = true;
  ASSERT_TRUE(QTest::qWaitFor([&] { return second; }));
  EXPECT_FALSE(first);
}

}  // namespace
}  // namespace glissade
