// Tests the pace that a run has by itself, with the hand of a person and without it.
#include <gtest/gtest.h>

#include <QAbstractSpinBox>
#include <QtTest>

#include <algorithm>

#include "tests/app/whole_window.h"

namespace glissade {
namespace {

class HandPace : public test::WholeWindowTest {
 protected:
  void open(const char* name) { ASSERT_FALSE(window_->openScenario(sample(name), true)); }
  void choose(const char* strategy) { session_.post(command::SetPlanner{strategy}); }
  void setPace(double pace) { session_.post(command::SetParameter{ParameterId::Pace, pace}); }

  /// Waits until the session has this pace and keeps it.
  bool stays(double pace) {
    const auto isThere = [&] { return session_.snapshot()->parameters[ParameterId::Pace] == pace; };
    if (!QTest::qWaitFor(isThere)) return false;
    QTest::qWait(kSettled);
    return isThere();
  }

  static constexpr int kSettled = 100;
  static constexpr double kOfPerson = 40.0;
  static constexpr double kFull = 0.0;

  std::unique_ptr<MainWindow> window_ = makeWindow(SessionClock::RealTime);
  SessionBridge& session_ = window_->workbench().session;
};

INSTANTIATE_TEST_SUITE_P(Languages, HandPace, testing::Values("en"));

TEST_P(HandPace, IsThatOfThePersonWhereTheirHandLeads) {
  open("environment-1");  // strategy "contact-birrt"
  EXPECT_TRUE(stays(kOfPerson));
  open("environment-2");
  EXPECT_TRUE(stays(kOfPerson));
  choose("by-hand");
  EXPECT_TRUE(stays(kOfPerson));
  choose("auto");
  EXPECT_TRUE(stays(kFull));
  choose("contact-birrt");
  EXPECT_TRUE(stays(kOfPerson));
  session_.setDevice("expert");
  EXPECT_TRUE(stays(kFull));
  session_.setDevice("hand");
  EXPECT_TRUE(stays(kOfPerson));
  open("teaching");  // layers
  EXPECT_TRUE(stays(kFull));
}

TEST_P(HandPace, StaysAsThePersonHasSetIt) {
  open("environment-1");
  ASSERT_TRUE(stays(kOfPerson));
  setPace(kFull);
  EXPECT_TRUE(stays(kFull));
  choose("by-hand");
  EXPECT_TRUE(stays(kFull));
  setPace(200.0);
  EXPECT_TRUE(stays(200.0));
  session_.setDevice("expert");
  EXPECT_TRUE(stays(200.0));
  session_.setDevice("hand");
  EXPECT_TRUE(stays(200.0));
}

/// The keys that steer would be typed into the field that was used last.
TEST_P(HandPace, ARunThatAPersonLeadsHasTheKeysOfTheScene) {
  open("environment-1");
  ASSERT_TRUE(stays(kOfPerson));
  window_->show();
  const auto fields = window_->findChildren<QAbstractSpinBox*>();
  const auto field = std::find_if(fields.begin(), fields.end(), [](const auto* each) { return each->isVisible(); });
  ASSERT_NE(field, fields.end());
  (*field)->setFocus();
  ASSERT_EQ(window_->focusWidget(), *field);
  window_->workbench().actions[QStringLiteral("run.start")]->trigger();
  EXPECT_EQ(window_->focusWidget(), window_->workbench().scene.widget());
}

}  // namespace
}  // namespace glissade
