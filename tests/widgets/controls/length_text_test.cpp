#include "widgets/controls/length_text.h"

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

TEST(LengthText, IsInTheUnitThatWasChosen) {
  QLocale::setDefault(QLocale::c());
  setLengthUnit(LengthUnit::Millimetres);
  EXPECT_EQ(lengthText(1.52), QStringLiteral("1520 mm"));
  EXPECT_EQ(lengthText(3.214e-6), QStringLiteral("0.00321 mm"));
  setLengthUnit(LengthUnit::Inches);
  EXPECT_EQ(lengthText(0.0254), QStringLiteral("1.00 in"));
  EXPECT_EQ(lengthText(0.0), QStringLiteral("0 in"));
  setLengthUnit(LengthUnit::Metres);
  EXPECT_EQ(lengthText(0.024), QStringLiteral("0.0240 m"));
  setLengthUnit(LengthUnit::Fitting);
}

TEST(LengthText, AColumnHasOneUnit) {
  QLocale::setDefault(QLocale::c());
  EXPECT_EQ(columnLengthText(9.99e-7), QStringLiteral("0.000999 mm"));
  EXPECT_EQ(columnLengthText(9.9966e-7), QStringLiteral("0.00100 mm"));
  EXPECT_EQ(columnLengthText(1.52), QStringLiteral("1520 mm"));
  EXPECT_EQ(columnLengthText(0.0), QStringLiteral("0 mm"));
  EXPECT_EQ(columnLengthText(std::numeric_limits<double>::infinity()), QString::fromUtf8("∞"));
  setLengthUnit(LengthUnit::Inches);
  EXPECT_EQ(columnLengthText(0.0254), QStringLiteral("1.00 in"));
  setLengthUnit(LengthUnit::Fitting);
}

TEST(LengthText, FieldsShowAsFineADifferenceAsTheyAreAskedFor) {
  EXPECT_EQ(lengthField(1e-5).unit, QStringLiteral("mm"));
  EXPECT_EQ(lengthField(1e-5).decimals, 2);
  EXPECT_EQ(lengthField(1e-9).unit, QString::fromUtf8("µm"));
  EXPECT_EQ(lengthField(1e-9).decimals, 3);
  setLengthUnit(LengthUnit::Inches);
  EXPECT_EQ(lengthField(1e-5).decimals, 4);
  EXPECT_NEAR(lengthField(1e-5).perMetre, 39.3701, 1e-4);
  setLengthUnit(LengthUnit::Metres);
  EXPECT_EQ(lengthField(1e-5).decimals, 5);
  setLengthUnit(LengthUnit::Fitting);
}

}  // namespace
}  // namespace glissade
