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

}  // namespace
}  // namespace glissade
