#include "widgets/contacts/fits_panel.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QFocusEvent>
#include <QSignalSpy>

#include "app/window/window_actions.h"

namespace glissade {
namespace {

PairFit pairOf(const char* a, const char* b, ContactKind kind, double overlap, bool refused) {
  PairFit fit;
  fit.a = BodyId(a);
  fit.b = BodyId(b);
  fit.shown = {a, b};
  fit.contact.kind = kind;
  fit.contact.overlap = overlap;
  Fit taken;
  taken.allowance = overlap + 1e-6;
  taken.thinned = std::make_shared<const TriangleMesh>();
  if (!refused) fit.ways[0].taken.push_back(taken);
  if (refused) fit.ways[0].refused = Message("overlap by 2 mm, which is a clash");
  return fit;
}

class FitsPanelTest : public ::testing::Test {
 protected:
  FitsPanelTest() : actions(windowActions(), nullptr), panel(actions) {
    panel.setFits(std::make_shared<const std::vector<PairFit>>(
        std::vector<PairFit>{pairOf("nut", "bolt", ContactKind::Cylindrical, 0.0, false),
                             pairOf("screw", "plate", ContactKind::Thread, 4e-4, false),
                             pairOf("arm", "plate", ContactKind::Clash, 2e-3, true)}));
  }

  QTreeWidget& table() { return *panel.findChild<QTreeWidget*>(); }
  int shown() {
    int count = 0;
    for (int i = 0; i < table().topLevelItemCount(); ++i) count += table().topLevelItem(i)->isHidden() ? 0 : 1;
    return count;
  }

  ActionCatalogue actions;
  FitsPanel panel;
};

TEST_F(FitsPanelTest, AllPairsAreRowsAndTheFilterLeavesSome) {
  EXPECT_EQ(shown(), 3);
  auto* filter = panel.findChild<QLineEdit*>();
  filter->setText(QStringLiteral("PLATE"));
  EXPECT_EQ(shown(), 2);
  filter->setText(QStringLiteral("clash"));
  EXPECT_EQ(shown(), 1);
  filter->clear();
  EXPECT_EQ(shown(), 3);
}

TEST_F(FitsPanelTest, ADialogThatClosesChoosesNoRow) {
  const QSignalSpy chosen(&panel, &FitsPanel::chosenChanged);
  QFocusEvent back(QEvent::FocusIn, Qt::ActiveWindowFocusReason);
  QApplication::sendEvent(&table(), &back);
  EXPECT_EQ(chosen.size(), 0);
  QFocusEvent byTab(QEvent::FocusIn, Qt::TabFocusReason);
  QApplication::sendEvent(&table(), &byTab);
  EXPECT_EQ(chosen.size(), 1) << "a person who goes there with Tab sees where they are";
}

TEST_F(FitsPanelTest, TipsSayWhichBodyGivesWayAndWhyNothingPasses) {
  QStringList tips;
  for (int i = 0; i < 3; ++i) tips << table().topLevelItem(i)->toolTip(4);
  EXPECT_TRUE(tips.contains(QStringLiteral("Allowance of nut: 1.00 µm"))) << tips.join('|').toStdString();
  EXPECT_TRUE(tips.contains(QStringLiteral("overlap by 2 mm, which is a clash"))) << tips.join('|').toStdString();
}

TEST_F(FitsPanelTest, LengthsAreSortedByTheirValues) {
  for (int column = 0; column < table().columnCount(); ++column) {
    if (table().headerItem()->text(column) == QStringLiteral("Allowance"))
      table().sortByColumn(column, Qt::AscendingOrder);
  }
  QStringList order;
  for (int i = 0; i < 3; ++i) order << table().topLevelItem(i)->text(2);
  EXPECT_EQ(order, (QStringList{QStringLiteral("arm"), QStringLiteral("nut"), QStringLiteral("screw")}));
}

TEST_F(FitsPanelTest, TheChosenPairIsThatOfTheRowHoweverItIsSorted) {
  QSignalSpy changed(&panel, &FitsPanel::chosenChanged);
  ASSERT_TRUE(panel.choose(QStringLiteral("plate"), QStringLiteral("screw")));
  EXPECT_EQ(changed.size(), 1);
  ASSERT_NE(panel.chosen(), nullptr);
  EXPECT_EQ(panel.chosen()->contact.kind, ContactKind::Thread);
  table().sortByColumn(0, Qt::DescendingOrder);
  EXPECT_EQ(panel.chosen()->a, "screw");
  EXPECT_FALSE(panel.choose(QStringLiteral("nut"), QStringLiteral("plate")));
  panel.setFits(nullptr);
  EXPECT_EQ(panel.chosen(), nullptr);
}

TEST_F(FitsPanelTest, ABodyThatIsChosenElsewhereHasItsRow) {
  QSignalSpy chosen(&panel, &FitsPanel::chosenChanged);
  panel.showBodies({QStringLiteral("plate")});
  ASSERT_NE(panel.chosen(), nullptr);
  EXPECT_EQ(panel.chosen()->b, "plate");
  const PairFit* first = panel.chosen();
  panel.showBodies({QStringLiteral("plate"), QStringLiteral("nut")});
  EXPECT_EQ(panel.chosen(), first);
  panel.showBodies({QStringLiteral("nut")});
  EXPECT_EQ(panel.chosen()->a, "nut");
  EXPECT_TRUE(chosen.isEmpty()) << "what is chosen elsewhere stays";
}

}  // namespace
}  // namespace glissade
