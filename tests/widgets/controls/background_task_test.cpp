#include "widgets/controls/background_task.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QThread>
#include <QtTest>

namespace glissade {
namespace {

/// Work that runs until it is stopped.
BackgroundTask::Work endless(std::atomic<bool>& stopped, bool& delivered) {
  return [&stopped, &delivered](const WorkWatch& watch) -> BackgroundTask::Delivery {
    watch.report(0.5);
    while (!watch.stop.stopRequested()) QThread::msleep(1);
    stopped = true;
    return [&delivered] { delivered = true; };
  };
}

TEST(BackgroundTask, DeliversOnItsOwnThreadWhatWasFoundOnAnother) {
  BackgroundTask task;
  QSignalSpy ended(&task, &BackgroundTask::ended);
  QThread* worked = nullptr;
  QThread* delivered = nullptr;
  task.start(
      GLISSADE_TEXT("looking"),
      [&](const WorkWatch&) -> BackgroundTask::Delivery {
        worked = QThread::currentThread();
        return [&] { delivered = QThread::currentThread(); };
      },
      false);
  EXPECT_TRUE(task.isBusy());
  ASSERT_TRUE(QTest::qWaitFor([&] { return delivered != nullptr; }));
  EXPECT_NE(worked, delivered);
  EXPECT_EQ(delivered, QThread::currentThread());
  EXPECT_EQ(ended.count(), 1);
  EXPECT_FALSE(task.isBusy());
}

TEST(BackgroundTask, TellsHowFarItIsAndForgetsWhatIsCancelled) {
  BackgroundTask task;
  QSignalSpy progressed(&task, &BackgroundTask::progressed);
  std::atomic<bool> stopped{false};
  bool delivered = false;
  task.start(GLISSADE_TEXT("waiting"), endless(stopped, delivered), false);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !progressed.isEmpty(); }));
  EXPECT_EQ(progressed.last().first().toDouble(), 0.5);
  task.cancel();
  EXPECT_FALSE(task.isBusy());
  ASSERT_TRUE(QTest::qWaitFor([&] { return stopped.load(); }));
  QTest::qWait(20);
  EXPECT_FALSE(delivered);
}

TEST(BackgroundTask, AnotherStartTakesThePlaceOfTheOneUnderWay) {
  BackgroundTask task;
  std::atomic<bool> stopped{false};
  bool first = false;
  bool second = false;
  task.start(GLISSADE_TEXT("waiting"), endless(stopped, first), false);
  task.start(
      GLISSADE_TEXT("looking"), [&](const WorkWatch&) -> BackgroundTask::Delivery { return [&] { second = true; }; },
      false);
  ASSERT_TRUE(QTest::qWaitFor([&] { return second && stopped.load(); }));
  QTest::qWait(20);
  EXPECT_FALSE(first);
}

TEST(BackgroundTask, AtOnceItIsDoneBeforeStartReturns) {
  BackgroundTask task;
  bool delivered = false;
  task.start(
      GLISSADE_TEXT("looking"), [&](const WorkWatch&) -> BackgroundTask::Delivery { return [&] { delivered = true; }; },
      true);
  EXPECT_TRUE(delivered);
  EXPECT_FALSE(task.isBusy());
}

}  // namespace
}  // namespace glissade
