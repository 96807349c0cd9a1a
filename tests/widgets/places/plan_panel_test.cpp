#include "widgets/places/plan_panel.h"

#include <gtest/gtest.h>

#include <QHeaderView>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>

#include "app/window/window_actions.h"
#include "engine/places/environment_model.h"

namespace glissade {
namespace {

/// Places of one cell each in a row, so that models with different numbers of places differ.
EnvironmentModelPtr placesInARow(int count) {
  auto model = std::make_shared<EnvironmentModel>();
  model->map.grid.counts = {count, 1, 1};
  for (int place = 0; place < count; ++place) model->map.placeOf.push_back(place);
  return model;
}

CoarsePlanPtr planThrough(const std::vector<int>& places, const EnvironmentModelPtr& environment) {
  CoarsePlan plan;
  plan.basis.environment = environment;
  plan.nodes = {0, 1};
  for (const int place : places) {
    TopologicalStep step;
    step.place = place;
    step.border = 10 + place;
    step.placeName = "P" + std::to_string(place + 1);
    step.why = Message("because of " + step.placeName);
    plan.steps.push_back(step);
  }
  return std::make_shared<const CoarsePlan>(plan);
}

class PlanPanelTest : public testing::Test {
 protected:
  PlanPanelTest() { panel.resize(320, 400); }

  QTreeWidget& steps() { return *panel.findChild<QTreeWidget*>(QStringLiteral("steps")); }
  bool says(const QString& text) {
    const auto labels = panel.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [&](QLabel* label) { return label->text().contains(text); });
  }
  void click(int row) {
    const QRect box = steps().visualItemRect(steps().topLevelItem(row));
    QTest::mouseClick(steps().viewport(), Qt::LeftButton, Qt::NoModifier, box.center());
  }

  const EnvironmentModelPtr environment = placesInARow(9);
  ActionCatalogue actions{windowActions(), nullptr};
  PlanPanel panel{actions};
};

TEST_F(PlanPanelTest, TheStepThatIsLookedAtStaysTheSameWhereverItsRowGoes) {
  panel.setPlan(planThrough({0, 8, 1, 2}, environment));
  click(1);
  ASSERT_EQ(panel.currentStep(), 1U);
  panel.setPlan(planThrough({0, 3, 4, 8, 2}, environment));
  EXPECT_EQ(panel.currentStep(), 3U);
  EXPECT_TRUE(says(QStringLiteral("because of P9")));
  panel.setPlan(planThrough({8, 2}, placesInARow(9)));
  EXPECT_EQ(panel.currentStep(), 0U) << "the same places, modelled anew";
}

TEST_F(PlanPanelTest, WithoutThatStepNoneIsLookedAt) {
  panel.setPlan(planThrough({0, 8, 1, 2}, environment));
  click(1);
  panel.setPlan(planThrough({0, 5, 1, 2}, environment));
  EXPECT_EQ(panel.currentStep(), std::nullopt);
  EXPECT_FALSE(says(QStringLiteral("because of")));
  click(2);
  panel.setPlan(planThrough({0, 5, 1, 2}, placesInARow(7)));
  EXPECT_EQ(panel.currentStep(), std::nullopt) << "place 1 of another map is another place";
}

TEST_F(PlanPanelTest, AClickOnTheRowThatIsHighlightedChoosesItAgain) {
  panel.setPlan(planThrough({0, 8}, environment));
  click(1);
  QSignalSpy chosen(&panel, &PlanPanel::stepChosen);
  click(1);
  EXPECT_GE(chosen.count(), 1);
}

TEST_F(PlanPanelTest, WithoutAWayItSaysSoAndWhy) {
  CoarsePlan none;
  none.basis.environment = environment;
  none.forbidden = {"P4", "P9"};
  panel.setPlan(std::make_shared<const CoarsePlan>(none));
  EXPECT_TRUE(says(QStringLiteral("No path through the places. Forbidden: P4, P9.")));
  EXPECT_FALSE(says(QStringLiteral("not tried yet")));
}

TEST_F(PlanPanelTest, ItTellsWhenTheWholeWorkspaceWasSearchedInstead) {
  auto plan = *planThrough({0, 8, TopologicalStep::kWholeWorkspace}, environment);
  plan.steps[0].result = StepResult::Failed;
  plan.steps[2].result = StepResult::Solved;
  plan.attempt = 2;
  panel.setPlan(std::make_shared<const CoarsePlan>(plan));
  EXPECT_TRUE(says(QStringLiteral("Solved by the search of the whole workspace, after 2 coarse paths")));
  EXPECT_EQ(steps().topLevelItem(2)->text(0), QStringLiteral("everywhere"));
}

TEST_F(PlanPanelTest, EveryColumnHasItsPlaceInANarrowDock) {
  auto plan = *planThrough({0, 8}, environment);
  plan.steps[0].planner = "contact-birrt";
  plan.steps[0].geometrical = true;
  plan.steps[0].randomConfigurations = 123456;
  panel.setPlan(std::make_shared<const CoarsePlan>(plan));
  panel.resize(300, 400);
  panel.show();
  QHeaderView* header = steps().header();
  EXPECT_LE(header->sectionViewportPosition(4) + header->sectionSize(4), steps().viewport()->width());
}

}  // namespace
}  // namespace glissade
