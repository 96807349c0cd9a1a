#include "widgets/controls/fresh_tips.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QHelpEvent>
#include <QTableWidget>
#include <QTest>
#include <QToolTip>

namespace glissade {
namespace {

TEST(FreshTips, ATipIsHiddenWhenTheRowBelowItHasAnother) {
  const FreshTips tips(nullptr);
  QTableWidget table(1, 1);
  auto* item = new QTableWidgetItem(QStringLiteral("cover"));
  item->setToolTip(QStringLiteral("certified"));
  table.setItem(0, 0, item);
  table.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&table));
  QApplication::processEvents();
  const QPoint at = table.visualItemRect(item).center();
  QHelpEvent asked(QEvent::ToolTip, at, table.viewport()->mapToGlobal(at));
  QApplication::sendEvent(table.viewport(), &asked);
  QApplication::processEvents();
  ASSERT_EQ(QToolTip::text(), QStringLiteral("certified"));
  table.viewport()->repaint();
  QTest::qWait(0);
  EXPECT_EQ(QToolTip::text(), QStringLiteral("certified")) << "nothing has changed";
  item->setToolTip(QStringLiteral("not valid"));
  table.viewport()->repaint();
  EXPECT_TRUE(QTest::qWaitFor([] { return !QToolTip::isVisible(); }));
}

}  // namespace
}  // namespace glissade
