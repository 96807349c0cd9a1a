#include "widgets/contacts/joints_panel.h"

#include <gtest/gtest.h>

#include <QSignalSpy>

#include "app/window/window_actions.h"
#include "tests/widgets/contacts/joint_parts.h"

namespace glissade {
namespace {

using test::screwedTable;

class JointsPanelTest : public ::testing::Test {
 protected:
  JointsPanelTest() : actions(windowActions(), nullptr), panel(actions) { panel.setTable(screwedTable()); }

  QTreeWidget& table() { return *panel.findChild<QTreeWidget*>(); }
  QString details() { return panel.findChild<QLabel*>(QStringLiteral("joint-details"))->text(); }
  QTreeWidgetItem& rowOf(const char* body) {
    for (int i = 0; i < table().topLevelItemCount(); ++i) {
      if (table().topLevelItem(i)->text(1) == QLatin1String(body)) return *table().topLevelItem(i);
    }
    throw std::runtime_error(body);
  }
  int shown() {
    int count = 0;
    for (int i = 0; i < table().topLevelItemCount(); ++i) count += table().topLevelItem(i)->isHidden() ? 0 : 1;
    return count;
  }
  void saySomething(JointKind kind, const char* body, JointEdit::Word word) {
    const JointTable& present = *panel.table();
    const JointKey key = test::rowOf(present, BodyId(body)).key;
    ASSERT_EQ(key.kind, kind);
    panel.setTable(std::make_shared<const JointTable>(present.with({{key, word}})));
  }

  ActionCatalogue actions;
  JointsPanel panel;
};

TEST_F(JointsPanelTest, ARowSaysWhatIsJoinedWithWhatAndHow) {
  QTreeWidgetItem& screw = rowOf("screw");
  EXPECT_EQ(screw.text(0), QStringLiteral("screw"));
  EXPECT_EQ(screw.text(2), QStringLiteral("block; clamps plate"));
  EXPECT_EQ(screw.text(3), QStringLiteral("M5, 10.0 turns"));
  EXPECT_EQ(screw.text(4), QStringLiteral("recognised (?)"));
  EXPECT_TRUE(screw.font(4).bold()) << "it is doubtful";
  EXPECT_FALSE(rowOf("pin").font(4).bold());
  EXPECT_EQ(rowOf("plate").text(4), QStringLiteral("suggested"));
}

TEST_F(JointsPanelTest, TheFilterLeavesSomeRowsAndNothingIsChosenOfTheOthers) {
  EXPECT_EQ(shown(), 3);
  ASSERT_TRUE(panel.choose(JointKind::Screw, "screw"));
  auto* filter = panel.findChild<QLineEdit*>();
  filter->setText(QStringLiteral("INSERT"));
  EXPECT_EQ(shown(), 1);
  EXPECT_TRUE(panel.chosen().empty());
  filter->setText(QStringLiteral("suggested"));
  EXPECT_EQ(shown(), 1);
  filter->clear();
  EXPECT_EQ(shown(), 3);
}

TEST_F(JointsPanelTest, TipsAndDetailsSayWhatItWasConcludedFrom) {
  EXPECT_TRUE(rowOf("screw").toolTip(4).contains(QStringLiteral("a shaft of 5 mm with a head")));
  EXPECT_EQ(rowOf("screw").toolTip(3), QStringLiteral("hexagon socket 4.00 mm"));
  EXPECT_EQ(rowOf("screw").toolTip(1), QStringLiteral("screw"));
  EXPECT_TRUE(details().startsWith(QStringLiteral("Joints: 3 (1 × screw, 1 × insert, 1 × unit); suggested: 1")))
      << details().toStdString();
  ASSERT_TRUE(panel.choose(JointKind::Screw, "screw"));
  EXPECT_TRUE(details().contains(QStringLiteral("the name says 'screw'"))) << details().toStdString();
  EXPECT_TRUE(details().contains(QStringLiteral("drive: hexagon socket"))) << details().toStdString();
  panel.setTable(nullptr);
  EXPECT_EQ(details(), QStringLiteral("Not looked for yet."));
}

TEST_F(JointsPanelTest, ThreadsAreSortedByTheirDiameter) {
  table().sortByColumn(3, Qt::DescendingOrder);
  EXPECT_EQ(table().topLevelItem(0)->text(1), QStringLiteral("screw"));
  table().sortByColumn(1, Qt::AscendingOrder);
  EXPECT_EQ(table().topLevelItem(0)->text(1), QStringLiteral("pin"));
}

TEST_F(JointsPanelTest, WhatIsDissolvedStaysGreyAndChosen) {
  ASSERT_TRUE(panel.choose(JointKind::Screw, "screw"));
  QSignalSpy changed(&panel, &JointsPanel::chosenChanged);
  saySomething(JointKind::Screw, "screw", JointEdit::Word::Dissolved);
  EXPECT_EQ(changed.size(), 1);
  ASSERT_EQ(panel.chosen().size(), 1U);
  EXPECT_EQ(panel.chosen()[0]->state, JointRowState::Dissolved);
  EXPECT_EQ(rowOf("screw").text(4), QStringLiteral("dissolved"));
  EXPECT_TRUE(rowOf("screw").font(0).strikeOut());
  EXPECT_FALSE(rowOf("screw").font(0).bold());
}

TEST_F(JointsPanelTest, SeveralRowsAreChosenHoweverTheyAreSorted) {
  rowOf("screw").setSelected(true);
  rowOf("pin").setSelected(true);
  table().sortByColumn(1, Qt::DescendingOrder);
  const auto chosen = panel.chosen();
  ASSERT_EQ(chosen.size(), 2U);
  EXPECT_EQ(chosen[0]->key.body, "screw");
  EXPECT_EQ(chosen[1]->key.body, "pin");
  EXPECT_FALSE(panel.choose(JointKind::Nut, "screw"));
}

TEST_F(JointsPanelTest, ABodyThatIsChosenElsewhereHasItsRow) {
  QSignalSpy chosen(&panel, &JointsPanel::chosenChanged);
  panel.showBodies({QStringLiteral("pin")});
  ASSERT_EQ(panel.chosen().size(), 1U);
  EXPECT_EQ(panel.chosen().front()->key.body, "pin");
  EXPECT_TRUE(chosen.isEmpty());
}

}  // namespace
}  // namespace glissade
