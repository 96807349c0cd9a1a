#include "widgets/controls/cell_delegates.h"

#include <gtest/gtest.h>

#include <QApplication>

namespace glissade {
namespace {

TEST(WholeWords, ANumberIsCutWithItsUnit) {
  const QFontMetrics metrics(QApplication::font());
  const QString line = QString::fromUtf8("down (−Z), 15.9 mm");
  const auto cutAt = [&](const char* text) {
    return wholeWords(line, metrics, metrics.horizontalAdvance(QString::fromUtf8(text)));
  };
  EXPECT_EQ(cutAt("down (−Z), 15.9 mm"), line);
  EXPECT_EQ(cutAt("down (−Z), 15.9 …"), QString::fromUtf8("down (−Z), …"));
  EXPECT_EQ(cutAt("down (−Z), …"), QString::fromUtf8("down (−Z), …"));
  EXPECT_EQ(cutAt("down …"), QString::fromUtf8("down …"));
}

TEST(WholeWords, LinesAreWrappedBetweenWords) {
  const QFontMetrics metrics(QApplication::font());
  const QString line = QString::fromUtf8("down (−Z), 15.9 mm, then +X, 20 mm");
  const int width = metrics.horizontalAdvance(QString::fromUtf8("down (−Z), 15.9 "));
  EXPECT_EQ(wrappedLines(line, metrics, 10 * width, 3), QStringList(line));
  EXPECT_EQ(
      wrappedLines(line, metrics, width, 3),
      (QStringList{QString::fromUtf8("down (−Z),"), QStringLiteral("15.9 mm, then"), QStringLiteral("+X, 20 mm")}));
  EXPECT_EQ(wrappedLines(line, metrics, width, 1), QStringList(line)) << "the last line has the rest";
  EXPECT_EQ(wrappedLines(QStringLiteral("oneverylongwordwithoutblanks"), metrics, 10, 3).size(), 1);
}

}  // namespace
}  // namespace glissade
