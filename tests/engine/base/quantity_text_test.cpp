#include "engine/base/quantity_text.h"

#include <gtest/gtest.h>

#include <numbers>

namespace glissade {
namespace {

TEST(QuantityText, LengthsAreReadInAnyUnit) {
  EXPECT_DOUBLE_EQ(*toMetres("25.4 mm", 1.0), 0.0254);
  EXPECT_DOUBLE_EQ(*toMetres("1in", 1.0), 0.0254);
  EXPECT_DOUBLE_EQ(*toMetres(" 0.5\" ", 1.0), 0.0127);
  EXPECT_DOUBLE_EQ(*toMetres("2 inch", 1.0), 0.0508);
  EXPECT_DOUBLE_EQ(*toMetres("-3 cm", 1.0), -0.03);
  EXPECT_DOUBLE_EQ(*toMetres("1.5e3 m", 1.0), 1500.0);
  EXPECT_DOUBLE_EQ(*toMetres("1 ft", 1.0), 0.3048);
  EXPECT_DOUBLE_EQ(*toMetres("6'", 1.0), 6 * 0.3048);
  EXPECT_DOUBLE_EQ(*toMetres("7 µm", 1.0), 7e-6);
  EXPECT_DOUBLE_EQ(*toMetres("7um", 1.0), 7e-6);
}

TEST(QuantityText, ANumberWithoutAUnitCountsInTheUnitOfTheField) {
  EXPECT_DOUBLE_EQ(*toMetres("12.5", 1e-3), 0.0125);
  EXPECT_DOUBLE_EQ(*toRadians("180", std::numbers::pi / 180.0), std::numbers::pi);
}

TEST(QuantityText, AnglesAreReadInDegreesAndRadians) {
  EXPECT_DOUBLE_EQ(*toRadians("30 deg", 1.0), std::numbers::pi / 6.0);
  EXPECT_DOUBLE_EQ(*toRadians("-90°", 1.0), -std::numbers::pi / 2.0);
  EXPECT_DOUBLE_EQ(*toRadians("0.1rad", 5.0), 0.1);
}

TEST(QuantityText, WhatIsNoQuantityIsRefused) {
  for (const char* text : {"", " ", "mm", "1 mn", "1,5 mm", "1 2 mm", "1 mm mm", "0x10", "nan", "1e400", "3 deg"}) {
    EXPECT_FALSE(toMetres(text, 1.0)) << text;
  }
  for (const char* text : {"", "deg", "3 mm", "1 degree", "inf rad"}) EXPECT_FALSE(toRadians(text, 1.0)) << text;
}

TEST(QuantityText, WritesThreeSignificantDigitsOfMillimetres) {
  EXPECT_EQ(inMillimetres(0.0), "0 mm");
  EXPECT_EQ(inMillimetres(5.6e-4), "0.56 mm");
  EXPECT_EQ(inMillimetres(1.23456e-5), "0.0123 mm");
  EXPECT_EQ(inMillimetres(0.179), "179 mm");
  EXPECT_EQ(inMillimetres(0.06327), "63.3 mm");
  EXPECT_EQ(inMillimetres(1.2348), "1235 mm") << "no exponent, and no digit before the point is lost";
  EXPECT_EQ(inMillimetres(-2e-3), "-2 mm");
}

}  // namespace
}  // namespace glissade
