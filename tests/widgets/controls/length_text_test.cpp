#include "widgets/controls/length_text.h"

#include <gtest/gtest.h>

#include <QLocale>

#include <cmath>
#include <limits>

namespace glissade {
namespace {

/// Puts the unit of the program back.
class LengthTextTest : public testing::Test {
 protected:
  LengthTextTest() { QLocale::setDefault(QLocale::c()); }
  ~LengthTextTest() override { setLengthUnit(LengthUnit::Millimetres); }
};

TEST_F(LengthTextTest, HasThreeDigitsInTheUnitOfTheProgram) {
  EXPECT_EQ(lengthText(0.0), QStringLiteral("0 mm"));
  EXPECT_EQ(lengthText(1.5e-4), QStringLiteral("0.150 mm"));
  EXPECT_EQ(lengthText(0.024), QStringLiteral("24.0 mm"));
  EXPECT_EQ(lengthText(1.52), QStringLiteral("1520 mm"));
  EXPECT_EQ(lengthText(-0.0105), QString::fromUtf8("−10.5 mm"));
  EXPECT_EQ(lengthText(std::numeric_limits<double>::infinity()), QString::fromUtf8("∞"));
  setLengthUnit(LengthUnit::Metres);
  EXPECT_EQ(lengthText(1.9971), QStringLiteral("2.00 m"));
  EXPECT_EQ(lengthText(0.15), QStringLiteral("0.150 m"));
  EXPECT_EQ(lengthText(0.0), QStringLiteral("0 m"));
  setLengthUnit(LengthUnit::Inches);
  EXPECT_EQ(lengthText(0.0254), QStringLiteral("1.00 in"));
}

TEST_F(LengthTextTest, ALengthThatNeedsManyDecimalsIsInASmallerUnit) {
  EXPECT_EQ(lengthText(1e-5), QStringLiteral("0.0100 mm"));
  EXPECT_EQ(lengthText(9.99e-6), QString::fromUtf8("9.99 µm"));
  setLengthUnit(LengthUnit::Metres);
  EXPECT_EQ(lengthText(0.00873), QStringLiteral("0.00873 m"));
  EXPECT_EQ(lengthText(0.000873), QStringLiteral("0.873 mm"));
  EXPECT_EQ(lengthText(3.214e-6), QString::fromUtf8("3.21 µm"));
  setLengthUnit(LengthUnit::Inches);
  EXPECT_EQ(lengthText(2.54e-6), QString::fromUtf8("100 µin"));
}

TEST_F(LengthTextTest, NeverShowsZeroForALengthThatIsNot) {
  for (double metres = 1e-11; metres < 1e4; metres *= 1.37) {
    const double shown = lengthText(metres).section(QLatin1Char(' '), 0, 0).toDouble();
    EXPECT_GT(shown, 0.0) << metres;
  }
}

TEST_F(LengthTextTest, LengthsOfOneThingHaveTheDigitsOfTheLargest) {
  EXPECT_EQ(lengthsText({0.04, -0.0125, 0.0}, QStringLiteral(" × ")), QString::fromUtf8("40.0 × −12.5 × 0.0 mm"));
  EXPECT_EQ(lengthsText({-3.75e-5, -1e-12, 0.0}, QStringLiteral("  ")),
            QString::fromUtf8("−0.0375  0.0000  0.0000 mm"));
  setLengthUnit(LengthUnit::Metres);
  EXPECT_EQ(lengthsText({4.85, 0.012}, QStringLiteral("  ")), QStringLiteral("4.85  0.01 m"));
  EXPECT_EQ(lengthsText({0.0, 0.0}, QStringLiteral("  ")), QStringLiteral("0  0 m"));
}

TEST_F(LengthTextTest, AColumnHasOneUnit) {
  EXPECT_EQ(columnLengthText(2.55e-5), QStringLiteral("0.0255 mm"));
  EXPECT_EQ(columnLengthText(9.99e-7), QStringLiteral("0.0010 mm"));
  EXPECT_EQ(columnLengthText(1e-9), QStringLiteral("<0.0001 mm"));
  EXPECT_EQ(columnLengthText(-1e-9), QString::fromUtf8(">−0.0001 mm"));
  EXPECT_EQ(columnLengthText(1.52), QStringLiteral("1520 mm"));
  EXPECT_EQ(columnLengthText(0.0), QStringLiteral("0 mm"));
  EXPECT_EQ(columnLengthText(std::numeric_limits<double>::infinity()), QString::fromUtf8("∞"));
  setLengthUnit(LengthUnit::Metres);
  EXPECT_EQ(columnLengthText(0.000873), QStringLiteral("0.873 mm")) << "gaps are small";
  setLengthUnit(LengthUnit::Inches);
  EXPECT_EQ(columnLengthText(0.0254), QStringLiteral("1.00 in"));
}

TEST_F(LengthTextTest, APlotHasOneUnitAndMarksWithoutZerosAtTheEnd) {
  setLengthUnit(LengthUnit::Metres);
  const PlotLengths small(1e-5);
  EXPECT_EQ(small.mark(1e-5), QStringLiteral("0.01 mm"));
  EXPECT_EQ(small.mark(1e-3), QStringLiteral("1 mm"));
  EXPECT_EQ(small.mark(1.0), QStringLiteral("1000 mm"));
  EXPECT_EQ(small.text(0.15), QStringLiteral("150 mm"));
  EXPECT_EQ(small.text(1.23e-5), QStringLiteral("0.0123 mm"));
  EXPECT_EQ(PlotLengths(0.02).mark(0.1), QStringLiteral("0.1 m"));
  setLengthUnit(LengthUnit::Millimetres);
  EXPECT_EQ(PlotLengths(1e-7).mark(1e-6), QString::fromUtf8("1 µm"));
  EXPECT_EQ(PlotLengths(1e-6).text(1.23e-6), QStringLiteral("0.0012 mm"));
  setLengthUnit(LengthUnit::Inches);
  EXPECT_EQ(PlotLengths(0.00254).mark(0.0254), QStringLiteral("1 in"));
}

TEST_F(LengthTextTest, FieldsShowAsFineADifferenceAsTheyAreAskedFor) {
  EXPECT_EQ(lengthField(1e-5).unit, QStringLiteral("mm"));
  EXPECT_EQ(lengthField(1e-5).decimals, 2);
  EXPECT_EQ(lengthField(1e-9).unit, QString::fromUtf8("µm"));
  EXPECT_EQ(lengthField(1e-9).decimals, 3);
  setLengthUnit(LengthUnit::Inches);
  EXPECT_EQ(lengthField(1e-5).decimals, 4);
  EXPECT_NEAR(lengthField(1e-5).perMetre, 39.3701, 1e-4);
  setLengthUnit(LengthUnit::Metres);
  EXPECT_EQ(lengthField(1e-5).decimals, 5);
}

TEST_F(LengthTextTest, AFieldHasTheUnitOfTheTextAndOneMoreDigit) {
  EXPECT_EQ(usualLengthField(0.15).unit, QStringLiteral("mm"));
  EXPECT_EQ(usualLengthField(0.15).decimals, 1);
  setLengthUnit(LengthUnit::Metres);
  EXPECT_EQ(usualLengthField(1.9971).unit, QStringLiteral("m"));
  EXPECT_EQ(usualLengthField(1.9971).decimals, 3);
  EXPECT_EQ(usualLengthField(1e-5).unit, QStringLiteral("mm"));
}

}  // namespace
}  // namespace glissade
