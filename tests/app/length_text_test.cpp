#include "widgets/commands/length_text.h"

#include <gtest/gtest.h>

#include <QLocale>

#include <cmath>
#include <limits>

namespace glissade {
namespace {

TEST(LengthText, HasTheUnitThatFitsAndThreeDigits) {
  QLocale::setDefault(QLocale::c());
  EXPECT_EQ(lengthText(0.0), QStringLiteral("0 mm"));
  EXPECT_EQ(lengthText(3.214e-6), QString::fromUtf8("3.21 µm"));
  EXPECT_EQ(lengthText(1.5e-4), QStringLiteral("0.150 mm"));
  EXPECT_EQ(lengthText(0.024), QStringLiteral("24.0 mm"));
  EXPECT_EQ(lengthText(0.4376), QStringLiteral("438 mm"));
  EXPECT_EQ(lengthText(1.52), QStringLiteral("1.52 m"));
  EXPECT_EQ(lengthText(-0.0105), QStringLiteral("-10.5 mm"));
  EXPECT_EQ(lengthText(std::numeric_limits<double>::infinity()), QString::fromUtf8("∞"));
}

TEST(LengthText, NeverShowsZeroForALengthThatIsNot) {
  QLocale::setDefault(QLocale::c());
  for (double metres = 1e-11; metres < 1e4; metres *= 1.37) {
    const double shown = lengthText(metres).section(QLatin1Char(' '), 0, 0).toDouble();
    EXPECT_GT(shown, 0.0) << metres;
  }
}

}  // namespace
}  // namespace glissade
