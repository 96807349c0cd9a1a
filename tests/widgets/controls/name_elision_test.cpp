#include "widgets/controls/name_elision.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QRegularExpression>
#include <QScrollBar>

#include "widgets/controls/name_table.h"

namespace glissade {
namespace {

/// The names of the nuts and bolts of a common exchange file.
QStringList bracketNames() {
  QStringList names{QStringLiteral("plate"), QStringLiteral("rod")};
  for (int bracket = 1; bracket <= 2; ++bracket) {
    for (int bolt = 1; bolt <= 3; ++bolt) {
      const QString of = QStringLiteral("l-bracket-assembly_%1/nut-bolt-assembly_%2/").arg(bracket).arg(bolt);
      names << of + QStringLiteral("nut") << of + QStringLiteral("bolt");
    }
  }
  return names;
}

class NameElisionTest : public testing::Test {
 protected:
  int widthOf(const char* text) const { return metrics_.horizontalAdvance(QString::fromUtf8(text)); }
  QString elided(const QStringList& names, const QString& name, int width) const {
    return NameElision(names).elided(name, metrics_, width);
  }

  QFontMetrics metrics_{QApplication::font()};
};

TEST_F(NameElisionTest, ANameThatFitsIsWhole) {
  EXPECT_EQ(elided({QStringLiteral("nut")}, QStringLiteral("nut"), widthOf("nut")), QStringLiteral("nut"));
}

TEST_F(NameElisionTest, NamesAreToldApartInLittleRoom) {
  const QStringList names = bracketNames();
  const int width = widthOf("…_1/…_1/bolt");
  QStringList shown;
  for (const QString& name : names) {
    shown << elided(names, name, width);
    EXPECT_LE(metrics_.horizontalAdvance(shown.back()), width) << shown.back().toStdString();
  }
  EXPECT_EQ(shown.removeDuplicates(), 0) << shown.join(QLatin1Char('\n')).toStdString();
}

TEST_F(NameElisionTest, NamesAreToldApartInNoRoomAtAll) {
  QStringList shown;
  for (const QString& name : bracketNames()) shown << elided(bracketNames(), name, 0);
  EXPECT_EQ(shown.removeDuplicates(), 0) << shown.join(QLatin1Char('\n')).toStdString();
}

TEST_F(NameElisionTest, ANumberIsWholeOrLeftOut) {
  const QStringList names{QStringLiteral("screw M6x120"), QStringLiteral("screw M6x20"), QStringLiteral("screw M8x20")};
  for (int width = 0; width < widthOf("screw M6x120"); ++width) {
    for (const QString& name : names) {
      auto numbers = QRegularExpression(QStringLiteral("\\d+")).globalMatch(elided(names, name, width));
      while (numbers.hasNext()) {
        const QString number = numbers.next().captured();
        EXPECT_TRUE(name.contains(QRegularExpression(QStringLiteral("(?<!\\d)%1(?!\\d)").arg(number))))
            << number.toStdString() << " in " << name.toStdString();
      }
    }
  }
}

TEST(NameTable, NamesHaveAReadableWidthAndTheTableIsScrolled) {
  NameTable table({{1, 0.5}, {2, 0.5}}, nullptr);
  table.setColumnCount(4);
  for (const QString& name : bracketNames()) {
    table.addTopLevelItem(new SortedRow({QStringLiteral("cylindrical"), name, name, QStringLiteral("allowed")}));
  }
  const int readable = 20 * table.fontMetrics().averageCharWidth();
  table.resize(320, 200);
  table.show();
  table.fitColumns();
  EXPECT_GE(table.columnWidth(1), readable);
  EXPECT_GE(table.columnWidth(2), readable);
  EXPECT_GT(table.horizontalScrollBar()->maximum(), 0);
  table.resize(1200, 200);
  EXPECT_GE(table.columnWidth(1), 2 * readable);
  QApplication::processEvents();
  EXPECT_EQ(table.horizontalScrollBar()->maximum(), 0);
}

}  // namespace
}  // namespace glissade
