#include "widgets/panels/sequence_panel.h"

#include <gtest/gtest.h>

#include <QSignalSpy>

#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

class SequencePanelTest : public ::testing::Test {
 protected:
  SequencePanelTest() : actions(nullptr), panel(actions) {
    auto product = std::make_shared<AssembledProduct>(test::lockedDrawer());
    auto plan = std::make_shared<AssemblyPlan>();
    for (const RigidBody& body : product->bodies) plan->bodies.push_back(body.id);
    plan->staying = {"cabinet"};
    for (const char* id : {"cap", "pin"}) {
      AssemblyStep step;
      step.body = id;
      step.path = {{Pose::identity(), Author::Computer}, {Pose::translation({0.0, 0.0, 1.0}), Author::Computer}};
      plan->steps.push_back(step);
    }
    plan->stuck = {{"drawer", {"cabinet"}}};
    plan->end = PlanEnd::Stuck;
    shown = {product, plan, false, {0.5, std::nullopt}, {StepCheck::Agrees, StepCheck::Disagrees}};
    panel.setPlan(shown);
  }

  QTreeWidget& table() { return *panel.findChild<QTreeWidget*>(); }
  QStringList parts() {
    QStringList names;
    for (int i = 0; i < table().topLevelItemCount(); ++i) names << table().topLevelItem(i)->text(1);
    return names;
  }

  ActionCatalogue actions;
  SequencePanel panel;
  ShownPlan shown;
};

TEST_F(SequencePanelTest, StepsAreRowsInTheOrderThatIsAskedForAndStuckPartsFollow) {
  EXPECT_EQ(parts(), (QStringList{QStringLiteral("cap"), QStringLiteral("pin"), QStringLiteral("drawer")}));
  EXPECT_TRUE(table().topLevelItem(0)->text(2).startsWith(QStringLiteral("up")));
  panel.setOrder(PlanOrder::Assembly);
  EXPECT_EQ(parts(), (QStringList{QStringLiteral("pin"), QStringLiteral("cap"), QStringLiteral("drawer")}));
  EXPECT_TRUE(table().topLevelItem(0)->text(2).startsWith(QStringLiteral("down")));
}

TEST_F(SequencePanelTest, TheOrderDoesNotChangeWhatIsShown) {
  panel.showTime(0.5);
  panel.setOrder(PlanOrder::Assembly);
  EXPECT_NEAR(panel.time(), 0.5, 1e-4);
  panel.setOrder(PlanOrder::Removal);
  EXPECT_NEAR(panel.time(), 0.5, 1e-4);
}

TEST_F(SequencePanelTest, ARowShowsItsStep) {
  for (const PlanOrder order : {PlanOrder::Removal, PlanOrder::Assembly}) {
    panel.setOrder(order);
    QSignalSpy changed(&panel, &SequencePanel::sceneChanged);
    ASSERT_TRUE(panel.chooseStep(1));
    EXPECT_NEAR(panel.time(), 1.5, 1e-4);
    EXPECT_EQ(panel.chosenStep(), std::optional<std::size_t>(1));
    EXPECT_GT(changed.size(), 0);
  }
  EXPECT_FALSE(panel.chooseStep(2));
}

TEST_F(SequencePanelTest, AStuckPartIsAnnounced) {
  QSignalSpy chosen(&panel, &SequencePanel::stuckChosen);
  table().setCurrentItem(table().topLevelItem(2));
  ASSERT_EQ(chosen.size(), 1);
  EXPECT_EQ(chosen[0][0].toString(), QStringLiteral("drawer"));
  EXPECT_FALSE(panel.chosenStep());
}

TEST_F(SequencePanelTest, APlanThatGrowsKeepsThePlaceAndHasNoStuckParts) {
  panel.showTime(1.0);
  shown.growing = true;
  panel.setPlan(shown);
  EXPECT_EQ(parts().size(), 2);
  EXPECT_NEAR(panel.time(), 1.0, 1e-4);
  panel.setPlan({});
  EXPECT_EQ(parts().size(), 0);
  EXPECT_EQ(panel.time(), 0.0);
}

}  // namespace
}  // namespace glissade
