#include "widgets/sequence/sequence_panel.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QtTest>

#include "app/window/window_actions.h"
#include "tests/engine/sequence/products.h"
#include "widgets/sequence/stuck_marks.h"

namespace glissade {
namespace {

class SequencePanelTest : public ::testing::Test {
 protected:
  SequencePanelTest() : actions(windowActions(), nullptr), panel(actions) {
    auto product = std::make_shared<AssembledProduct>(test::lockedDrawer());
    auto plan = std::make_shared<AssemblyPlan>();
    for (const RigidBody& body : product->bodies) plan->bodies.push_back(body.id);
    plan->staying = {"cabinet"};
    for (const char* id : {"cap", "pin"}) {
      AssemblyStep step{{StepMotion()}};
      step.only().body = BodyId(id);
      step.only().path = {{Pose::identity(), Author::Computer}, {Pose::translation({0.0, 0.0, 1.0}), Author::Computer}};
      plan->steps.push_back(step);
    }
    plan->stuck = {{"drawer", {"cabinet"}, Message("no motion was found, alone or with others")}};
    plan->end = PlanEnd::Stuck;
    shown = {
        product, plan, false, {{plan->steps[0].only().body, 0.5}}, {{StepCheck::Agrees, StepCheck::Disagrees}, {}}};
    panel.setOrder(PlanOrder::Removal);
    panel.setPlan(shown);
  }

  StepTable& table() { return *panel.findChild<StepTable*>(); }
  QStringList parts() {
    QStringList names;
    for (int i = 0; i < table().topLevelItemCount(); ++i) {
      const QTreeWidgetItem* row = table().topLevelItem(i);
      const BodyId stuck = StepTable::stuckOf(row);
      names << (stuck.empty() ? row->text(1).section(QLatin1Char('\n'), 0, 0) : QString::fromStdString(stuck.text()));
    }
    return names;
  }

  /// Drags the row of a step onto the upper or the lower half of another row.
  void drag(int from, int to, bool below) {
    table().resize(400, 400);
    table().setCurrentItem(table().topLevelItem(from));
    const QRect there = table().visualItemRect(table().topLevelItem(to));
    table().dropAt({there.center().x(), below ? there.bottom() - 1 : there.top() + 1});
  }

  ActionCatalogue actions;
  SequencePanel panel;
  ShownPlan shown;
};

TEST_F(SequencePanelTest, StepsAreRowsInTheOrderThatIsAskedForAndStuckPartsFollow) {
  EXPECT_EQ(parts(), (QStringList{QStringLiteral("cap"), QStringLiteral("pin"), QStringLiteral("drawer")}));
  EXPECT_TRUE(table().topLevelItem(0)->text(1).contains(QStringLiteral("\nup")));
  panel.setOrder(PlanOrder::Assembly);
  EXPECT_EQ(parts(), (QStringList{QStringLiteral("pin"), QStringLiteral("cap"), QStringLiteral("drawer")}));
  EXPECT_TRUE(table().topLevelItem(0)->text(1).contains(QStringLiteral("\ndown")));
}

TEST_F(SequencePanelTest, TheHeadlineSpeaksOfTheOrderThatIsShown) {
  const auto* summary = panel.findChild<QLabel*>(QStringLiteral("sequence-summary"));
  EXPECT_TRUE(summary->text().startsWith(QStringLiteral("2 of 3 parts removed"))) << summary->text().toStdString();
  panel.setOrder(PlanOrder::Assembly);
  EXPECT_TRUE(summary->text().startsWith(QStringLiteral("2 of 3 parts assembled"))) << summary->text().toStdString();
}

TEST_F(SequencePanelTest, AStepSaysHowTheProductIsTurnedBefore) {
  shown.views = {Viewpoint{0, false}, Viewpoint{0, true}};  // of the cap and of the pin
  for (const PlanOrder order : {PlanOrder::Assembly, PlanOrder::Removal}) {
    panel.setOrder(order);
    panel.setPlan(shown);
    for (int row = 0; row < 2; ++row) {
      const QTreeWidgetItem& step = *table().topLevelItem(row);
      const bool turns = order == PlanOrder::Assembly || row == 1;  // the cap leaves from the product as it lies
      EXPECT_EQ(step.text(1).simplified().contains(QStringLiteral("Turn the product over.")), turns) << row;
      EXPECT_EQ(step.toolTip(1).contains(QStringLiteral("Turn the product over.")), turns) << row;
    }
  }
}

TEST_F(SequencePanelTest, AStepSaysOnceAndWithItsReasonWhatIsHeld) {
  auto plan = std::make_shared<AssemblyPlan>(*shown.plan);
  plan->steps[1].only().falling = {"drawer"};
  shown.plan = plan;
  panel.setOrder(PlanOrder::Assembly);
  panel.setPlan(shown);
  const QString tip = table().topLevelItem(0)->toolTip(3);
  EXPECT_EQ(tip.count(QStringLiteral("drawer")), 1) << tip.toStdString();
  EXPECT_TRUE(tip.contains(QStringLiteral("because nothing supports it"))) << tip.toStdString();
}

/// The names and motions of the parts are short.
TEST_F(SequencePanelTest, WhatIsHeldIsNotCutBesideFreeRoom) {
  auto plan = std::make_shared<AssemblyPlan>(*shown.plan);
  for (AssemblyStep& step : plan->steps) step.only().falling = {"drawer"};
  shown.plan = plan;
  panel.setPlan(shown);
  panel.show();
  const QAbstractItemView& view = table();
  for (int width = 420; width < 700; width += 20) {
    panel.resize(width, 500);
    const int free = table().columnWidth(1) - view.sizeHintForColumn(1);
    const int lacking = view.sizeHintForColumn(3) - table().columnWidth(3);
    EXPECT_FALSE(free > 8 && lacking > 0 && table().columnWidth(1) > 120) << width << " " << free << " " << lacking;
  }
}

TEST_F(SequencePanelTest, APartThatTouchesNothingIsNamed) {
  auto plan = std::make_shared<AssemblyPlan>(*shown.plan);
  plan->isolated = {"cap"};
  shown.plan = plan;
  panel.setPlan(shown);
  EXPECT_TRUE(table().topLevelItem(0)->text(4).contains(QStringLiteral("touches nothing")));
  EXPECT_FALSE(table().topLevelItem(1)->text(4).contains(QStringLiteral("touches nothing")));
  EXPECT_TRUE(panel.findChild<QLabel*>(QStringLiteral("sequence-summary"))
                  ->text()
                  .contains(QStringLiteral("may lie beside the product: cap.")));
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

TEST_F(SequencePanelTest, AClickOnARowAnnouncesThatItsStepIsSelected) {
  panel.resize(600, 500);
  panel.show();
  std::vector<std::size_t> announced;
  QObject::connect(&panel, &SequencePanel::selectionChanged, [&] { announced = panel.selectedSteps(); });
  const QRect row = table().visualItemRect(table().topLevelItem(1));
  QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, row.center());
  EXPECT_EQ(announced, std::vector<std::size_t>{1});
}

TEST_F(SequencePanelTest, ADraggedStepIsAnnouncedAndStaysUntilThePlanIsAnother) {
  QSignalSpy moved(&panel, &SequencePanel::stepMoved);
  drag(1, 0, false);
  ASSERT_EQ(moved.size(), 1);
  EXPECT_EQ(moved[0][0].toInt(), 1);
  EXPECT_EQ(moved[0][1].toInt(), 0);
  EXPECT_EQ(parts().front(), QStringLiteral("cap"));
  drag(0, 2, true);
  ASSERT_EQ(moved.size(), 2);
  EXPECT_EQ(moved[1][1].toInt(), 1) << "not behind what is stuck";
  drag(0, 0, true);
  drag(2, 0, false);
  EXPECT_EQ(moved.size(), 2) << "nowhere else, and a stuck part";
  panel.setOrder(PlanOrder::Assembly);
  drag(1, 0, false);
  ASSERT_EQ(moved.size(), 3);
  EXPECT_EQ(moved[2][0].toInt(), 0);
  EXPECT_EQ(moved[2][1].toInt(), 1);
}

TEST_F(SequencePanelTest, KeysMoveTheStepAndNotTheSelection) {
  panel.show();
  panel.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&panel));
  ASSERT_TRUE(panel.chooseStep(1));
  table().setFocus();
  actions["sequence.step-up"]->setEnabled(true);
  QSignalSpy up(actions["sequence.step-up"], &QAction::triggered);
  QTest::keyClick(&table(), Qt::Key_Up, Qt::AltModifier);
  EXPECT_EQ(up.size(), 1);
  QTest::keyClick(&table(), Qt::Key_Up, Qt::AltModifier | Qt::KeypadModifier);
  EXPECT_EQ(up.size(), 2);
  EXPECT_EQ(panel.chosenStep(), std::optional<std::size_t>(1));
}

TEST_F(SequencePanelTest, KeysOfACommandThatIsOffDoNothing) {
  panel.show();
  panel.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&panel));
  table().setFocus();
  QAction* byHand = actions["sequence.by-hand"];
  const QSignalSpy triggered(byHand, &QAction::triggered);
  byHand->setEnabled(false);
  QTest::keyClick(&table(), Qt::Key_M, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_EQ(triggered.size(), 0);
}

TEST_F(SequencePanelTest, ARowSaysWhatAPersonHasDoneAndWhatIsForced) {
  auto plan = std::make_shared<AssemblyPlan>(*shown.plan);
  plan->demands.places = {{{"cap"}, 1, true}};
  plan->steps[1].only().method = kByHand;
  plan->steps[1].violates = {{StepViolation::Rule::Fastener, {"cap"}}};
  shown.plan = plan;
  panel.setAtOnce(true);
  panel.setPlan(shown);
  EXPECT_TRUE(table().topLevelItem(0)->text(4).contains(QStringLiteral("locked")));
  EXPECT_TRUE(table().topLevelItem(1)->text(4).contains(QStringLiteral("by hand")));
  EXPECT_TRUE(table().topLevelItem(1)->text(3).simplified().contains(QStringLiteral("nuts still on it: cap")));
  EXPECT_FALSE(table().topLevelItem(0)->icon(1).isNull());
}

TEST_F(SequencePanelTest, AStuckRowHasTheWholeReasonAndWhatToDoNext) {
  panel.resize(300, 500);
  panel.show();
  QApplication::processEvents();
  const QTreeWidgetItem* row = table().topLevelItem(2);
  const QString text = row->text(0);
  for (const char* part : {"drawer is stuck.", "Blocked by cabinet.", "No motion was found, alone or with others.",
                           "Next: decide about its fits and joints"}) {
    EXPECT_TRUE(text.contains(QLatin1String(part))) << part;
  }
  EXPECT_TRUE(row->isFirstColumnSpanned());
  const int narrow = table().sizeHintForIndex(table().model()->index(2, 0)).height();
  EXPECT_GT(narrow, 3 * table().fontMetrics().height()) << "all of it is seen";
  panel.resize(2000, 500);
  QApplication::processEvents();
  EXPECT_LT(table().sizeHintForIndex(table().model()->index(2, 0)).height(), narrow);
}

TEST_F(SequencePanelTest, NoRowStatesTheTimeThatComputingTook) {
  EXPECT_FALSE(table().topLevelItem(0)->text(4).contains(QStringLiteral("0.5")));
  EXPECT_TRUE(table().topLevelItem(0)->toolTip(4).contains(QStringLiteral("found after 0.5 s of computing")));
}

TEST_F(SequencePanelTest, APartThatIsChosenElsewhereHasItsRowAndTheSceneStays) {
  panel.showTime(0.5);
  QSignalSpy shownScene(&panel, &SequencePanel::sceneChanged);
  QSignalSpy selected(&panel, &SequencePanel::selectionChanged);
  panel.showBodies({QStringLiteral("pin")});
  EXPECT_EQ(panel.chosenStep(), std::optional<std::size_t>(1));
  EXPECT_EQ(selected.size(), 1);
  panel.showBodies({QStringLiteral("drawer"), QStringLiteral("pin")});
  EXPECT_EQ(panel.chosenStep(), std::optional<std::size_t>(1)) << "the row is about one of them";
  panel.showBodies({QStringLiteral("drawer")});
  EXPECT_EQ(panel.chosenStuck(), "drawer");
  panel.showBodies({QStringLiteral("cabinet")});
  EXPECT_EQ(panel.chosenStuck(), "drawer") << "nothing is about it";
  EXPECT_TRUE(shownScene.isEmpty());
}

TEST_F(SequencePanelTest, WhatBlocksAStuckPartIsMarkedUntilAStepIsChosen) {
  QUndoStack undo;
  SemanticDocument semantics(undo);
  new StuckMarks(semantics, panel);
  table().setCurrentItem(table().topLevelItem(2));
  const QSet<QString> marked{QStringLiteral("drawer"), QStringLiteral("cabinet")};
  EXPECT_EQ(semantics.selection().bodies, marked);
  table().setCurrentItem(table().topLevelItem(0));
  EXPECT_TRUE(semantics.selection().bodies.isEmpty());
  table().setCurrentItem(table().topLevelItem(2));
  SemanticSelection own;
  own.bodies = {QStringLiteral("cap")};
  semantics.select(own);
  table().setCurrentItem(table().topLevelItem(0));
  EXPECT_EQ(semantics.selection().bodies, own.bodies) << "what a person has selected";
}

TEST_F(SequencePanelTest, AStuckPartIsAnnounced) {
  QSignalSpy chosen(&panel, &SequencePanel::stuckChosen);
  table().setCurrentItem(table().topLevelItem(2));
  ASSERT_EQ(chosen.size(), 1);
  EXPECT_EQ(chosen[0][0].toString(), QStringLiteral("drawer"));
  EXPECT_FALSE(panel.chosenStep());
  panel.showTime(2.0);
  EXPECT_EQ(panel.chosenStuck(), "drawer") << "it is shown when all that leave have left";
  panel.showTime(0.5);
  EXPECT_EQ(panel.chosenStep(), std::optional<std::size_t>(0));
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
