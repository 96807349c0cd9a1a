// The property view and the tree above it, used with keys and wheel as a person would.
#include <gtest/gtest.h>

#include <QApplication>
#include <QDoubleSpinBox>
#include <QMainWindow>
#include <QTest>
#include <QWheelEvent>

#include "app/window/window_actions.h"
#include "engine/files/scenario_io.h"
#include "tests/engine/support/directories.h"
#include "widgets/places/semantics_panel.h"
#include "widgets/workbench/editor_in_use.h"

namespace glissade {
namespace {

class AttributeViewTest : public testing::Test {
 protected:
  AttributeViewTest() : actions(windowActions(), &window), panel(new SemanticsPanel(document, actions, &window)) {
    auto loaded = loadScenario(test::sourceDirectory() + "/samples/teaching/scenario.json");
    scenario = std::make_shared<const LoadedScenario>(std::move(*loaded));
    document.open(*scenario);
    document.setKnowledge(*buildSceneKnowledge(scenario->problem, 1e-6));
    window.setCentralWidget(panel);
    window.addAction(actions["edit.undo"]);
    QObject::connect(actions["edit.undo"], &QAction::triggered, &undo, &QUndoStack::undo);
    window.resize(400, 800);
    window.show();
    window.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
    selectPlace(2);
  }

  void selectPlace(int place) {
    SemanticSelection selection;
    selection.places.insert(place);
    document.select(selection);
  }
  QWidget* editor(const char* attribute) {
    return panel->findChild<QWidget*>(QStringLiteral("attribute-") + QLatin1String(attribute));
  }
  QTreeWidget* attributes() { return panel->findChild<QTreeWidget*>(QStringLiteral("attributes")); }
  QTreeWidget* tree() { return panel->findChild<QTreeWidget*>(QStringLiteral("semantics-tree")); }
  AttributeValue value(const char* attribute) const { return document.semantics()->ofPlace(2, attribute).value; }
  static void turnWheel(QWidget* over, int notches) {
    const QPointF middle = QRectF(over->rect()).center();
    QWheelEvent event(middle, over->mapToGlobal(middle.toPoint()), {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(over, &event);
  }

  std::shared_ptr<const LoadedScenario> scenario;
  QUndoStack undo;
  SemanticDocument document{undo};
  QMainWindow window;
  ActionCatalogue actions;
  SemanticsPanel* panel;
};

TEST_F(AttributeViewTest, TheWheelOnlyTurnsTheEditorThatHasTheFocus) {
  const AttributeValue before = value("complexity");
  for (const char* attribute : {"complexity", "preference"}) turnWheel(editor(attribute), 1);
  EXPECT_EQ(value("complexity"), before);
  EXPECT_EQ(undo.count(), 0);
  editor("complexity")->setFocus();
  turnWheel(editor("complexity"), 1);
  EXPECT_EQ(undo.count(), 1);
  SemanticSelection body;
  body.bodies.insert(QStringLiteral("O5"));
  document.select(body);
  turnWheel(editor("mobility"), -1);
  EXPECT_EQ(undo.count(), 1);
}

TEST_F(AttributeViewTest, AnUnknownMassIsNoNumberAndASmallOneIsNotZero) {
  SemanticSelection body;
  body.bodies.insert(QStringLiteral("O5"));
  document.select(body);
  auto* mass = qobject_cast<QDoubleSpinBox*>(editor("mass"));
  ASSERT_NE(mass, nullptr);
  EXPECT_EQ(mass->text(), QStringLiteral("by volume"));
  mass->setValue(0.0004);
  EXPECT_EQ(mass->text(), QStringLiteral("0.0004 kg"));
}

TEST_F(AttributeViewTest, NoStepAndNoKeyLeadsBelowTheRange) {
  auto* box = qobject_cast<QSpinBox*>(editor("complexity"));
  box->setFocus();
  box->stepBy(-200);
  EXPECT_EQ(value("complexity"), AttributeValue(1.0));
  EXPECT_EQ(box->text(), QStringLiteral("1"));
  box->selectAll();
  QTest::keyClicks(box, QStringLiteral("0"));
  QTest::keyClick(box, Qt::Key_Return);
  EXPECT_EQ(box->text(), QStringLiteral("1"));
  auto* number = qobject_cast<QDoubleSpinBox*>(editor("preference"));
  number->stepBy(-200);
  EXPECT_EQ(value("preference"), AttributeValue(0.01));
}

TEST_F(AttributeViewTest, LengthsAreInMillimetresAsInTheTree) {
  auto* box = qobject_cast<QDoubleSpinBox*>(editor("narrowness"));
  EXPECT_EQ(box->text(), QStringLiteral("656.25 mm"));
  box->setValue(50.0);
  EXPECT_EQ(value("narrowness"), AttributeValue(0.05));
  EXPECT_EQ(tree()->topLevelItem(0)->child(2)->text(2), QStringLiteral("50.0 mm"));
}

TEST_F(AttributeViewTest, EveryCommittedEditIsOneStepBackAlsoFromInsideTheEditor) {
  auto* box = qobject_cast<QSpinBox*>(editor("complexity"));
  box->setFocus();
  for (const char* number : {"7", "3", "9"}) {
    box->selectAll();
    QTest::keyClicks(box, QLatin1String(number));
    QTest::keyClick(box, Qt::Key_Return);
  }
  ASSERT_EQ(undo.count(), 3);
  QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(value("complexity"), AttributeValue(3.0));
  EXPECT_EQ(box->value(), 3);
  QWidget* line = editor("shape");
  line->setFocus();
  QTest::keyClicks(line, QStringLiteral("round"));
  QTest::keyClick(line, Qt::Key_Return);
  EXPECT_EQ(value("shape"), AttributeValue(std::string("round")));
  QTest::keyClick(line, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(value("shape"), AttributeValue(std::string()));
}

TEST_F(AttributeViewTest, WhatIsTypedCountsBeforeAnActionAlsoWhileAPlaceIsRenamed) {
  QWidget* line = editor("shape");
  line->setFocus();
  QTest::keyClicks(line, QStringLiteral("round"));
  EXPECT_EQ(value("shape"), AttributeValue(std::string()));
  commitEditorInUse();
  EXPECT_EQ(value("shape"), AttributeValue(std::string("round")));
  EXPECT_EQ(QApplication::focusWidget(), line);
  tree()->setFocus();
  tree()->editItem(tree()->topLevelItem(0)->child(2), 0);
  ASSERT_NE(QApplication::focusWidget(), tree());
  QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("hall"));
  commitEditorInUse();
  EXPECT_EQ(document.semantics()->placeName(2), "hall");
}

TEST_F(AttributeViewTest, OnlyWhatIsShownIsEdited) {
  SemanticSelection both;
  both.places.insert(2);
  both.bodies.insert(QStringLiteral("object"));
  document.select(both);
  const auto bodies = document.edits().bodies;
  QWidget* line = editor("shape");
  line->setFocus();
  QTest::keyClicks(line, QStringLiteral("round"));
  QTest::keyClick(line, Qt::Key_Return);
  EXPECT_EQ(value("shape"), AttributeValue(std::string("round")));
  EXPECT_TRUE(document.edits().bodies == bodies);
  qobject_cast<QSpinBox*>(editor("complexity"))->setValue(7);
  EXPECT_EQ(value("complexity"), AttributeValue(7.0));
}

TEST_F(AttributeViewTest, KeysLeadToTheRowsAndAlongTheEditors) {
  tree()->setFocus();
  EXPECT_EQ(QApplication::focusWidget(), tree());
  for (const int key : {Qt::Key_F2, Qt::Key_Return, Qt::Key_Space}) {
    attributes()->setFocus();
    attributes()->setCurrentItem(attributes()->topLevelItem(2));
    QTest::keyClick(attributes(), static_cast<Qt::Key>(key));
    EXPECT_EQ(QApplication::focusWidget(), editor("narrowness"));
  }
  attributes()->setFocus();
  for (const char* attribute : {"complexity", "cluttered", "narrowness", "shape"}) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    EXPECT_EQ(QApplication::focusWidget(), editor(attribute)) << attribute;
  }
}

TEST_F(AttributeViewTest, ForbiddenAndPreferredPlacesAreMarked) {
  const QTreeWidgetItem* row = tree()->topLevelItem(0)->child(2);
  EXPECT_FALSE(row->text(1).contains(QStringLiteral("⊘")));
  ASSERT_TRUE(document.setAttribute(document.selection(), "forbidden", AttributeValue(true)).ok());
  ASSERT_TRUE(document.setAttribute(document.selection(), "preference", AttributeValue(4.0)).ok());
  EXPECT_TRUE(row->text(1).contains(QStringLiteral("⊘ ★"))) << row->text(1).toStdString();
  EXPECT_TRUE(row->toolTip(1).contains(QStringLiteral("Forbidden")));
}

TEST_F(AttributeViewTest, WhatTheFilterHidesIsSelectedNoMore) {
  auto* filter = panel->findChild<QLineEdit*>(QString(), Qt::FindDirectChildrenOnly);
  filter->setText(QStringLiteral("P3"));
  EXPECT_EQ(document.selection().places.size(), 1);
  filter->setText(QStringLiteral("P1"));
  EXPECT_TRUE(document.selection().places.isEmpty());
  EXPECT_EQ(attributes()->topLevelItemCount(), 0);
}

TEST_F(AttributeViewTest, AnEditThatCountsNowhereIsSaid) {
  const auto* warning = panel->findChild<QLabel*>(QStringLiteral("edit-warning"));
  EXPECT_FALSE(warning->isVisible());
  auto other = std::make_shared<LoadedScenario>(*scenario);
  other->scenario.places = {{{5, 5, 5}, "Nowhere", {}}};
  document.rearrange(*other);
  EXPECT_TRUE(warning->isVisible());
  EXPECT_TRUE(warning->text().contains(QStringLiteral("/places/0: lies in no place"))) << warning->text().toStdString();
}

}  // namespace
}  // namespace glissade
