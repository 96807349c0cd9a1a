#include "widgets/sequence/times_view.h"

#include <gtest/gtest.h>

#include <QSignalSpy>

namespace glissade {
namespace {

PlanTiming twoSteps(std::optional<std::size_t> stations) {
  PlanTiming timing{std::vector<StepTime>(2), {{6.0, 4.0}, {{}, {}}}, {0}};
  if (stations) timing.line = *balanceLine(timing.tasks, *stations);
  return timing;
}

class TimesViewTest : public ::testing::Test {
 protected:
  TimesViewTest() : view(nullptr) {}

  QString summary() const { return view.findChild<QLabel*>(QStringLiteral("times-summary"))->text(); }
  QSize chart() {
    const auto labels = view.findChildren<QLabel*>();
    for (const QLabel* label : labels) {
      if (label->pixmap(Qt::ReturnByValue).width() > 0) return label->pixmap(Qt::ReturnByValue).size();
    }
    return {};
  }

  TimesView view;
};

TEST_F(TimesViewTest, StatesTheSumTheChainAndTheCycleOfALine) {
  view.setTiming(twoSteps(std::nullopt), {});
  EXPECT_TRUE(summary().contains(QStringLiteral("10.0 s"))) << summary().toStdString();
  EXPECT_FALSE(summary().contains(QStringLiteral("Cycle time")));
  const QSize one = chart();
  view.setTiming(twoSteps(2), {});
  EXPECT_TRUE(summary().contains(QStringLiteral("Cycle time 6.0 s"))) << summary().toStdString();
  EXPECT_TRUE(summary().contains(QStringLiteral("83 %"))) << summary().toStdString();
  EXPECT_GT(chart().height(), one.height()) << "a bar more";
}

TEST_F(TimesViewTest, WithoutAPlanThereIsNoChart) {
  view.setTiming(twoSteps(2), {});
  view.setTiming(std::nullopt, {});
  EXPECT_EQ(summary(), QStringLiteral("There is no assembly plan."));
  EXPECT_TRUE(chart().isEmpty());
}

TEST_F(TimesViewTest, SaysHowManyValuesOfTheTableWereEdited) {
  PlanTiming timing = twoSteps(std::nullopt);
  timing.edited = 3;
  view.setTiming(timing, {});
  EXPECT_TRUE(summary().contains(QStringLiteral("3 of the 18 values"))) << summary().toStdString();
}

TEST_F(TimesViewTest, TheSumOfThePlanIsKnown) {
  view.setTiming(twoSteps(2), {});
  EXPECT_EQ(view.shownSeconds(), 10.0);
  view.setTiming(std::nullopt, {});
  EXPECT_EQ(view.shownSeconds(), 0.0);
}

TEST_F(TimesViewTest, TheTableIsAPageOfItsOwn) {
  view.show();
  EXPECT_FALSE(view.table().isVisible());
  view.showTable();
  EXPECT_TRUE(view.table().isVisible());
}

TEST_F(TimesViewTest, StationsAreAskedFor) {
  const QSignalSpy asked(&view, &TimesView::stationsChanged);
  view.setStations(4);
  EXPECT_EQ(view.stations(), 4);
  EXPECT_EQ(asked.count(), 1);
  view.setStations(0);
  EXPECT_EQ(view.stations(), 1);
}

}  // namespace
}  // namespace glissade
