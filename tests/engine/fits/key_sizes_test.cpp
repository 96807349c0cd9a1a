#include "engine/fits/key_sizes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace glissade {
namespace {

double millimetresOf(DriveKind drive, double across) {
  const auto key = keyFor(drive, 1e-3 * across);
  return key ? 1e3 * key->size : 0.0;
}

TEST(KeySizes, AKeyGoesIntoItsRecess) {
  EXPECT_NEAR(millimetresOf(DriveKind::HexSocket, 3.1), 3.0, 1e-9);
  EXPECT_NEAR(millimetresOf(DriveKind::HexSocket, 2.98), 3.0, 1e-9) << "a mesh of round corners";
  EXPECT_NEAR(millimetresOf(DriveKind::HexSocket, 3.0), 3.0, 1e-9);
  EXPECT_EQ(keyFor(DriveKind::HexSocket, 3.4e-3), std::nullopt) << "each key turns in it or does not go in";
}

TEST(KeySizes, AWrenchGoesOverItsHead) {
  EXPECT_NEAR(millimetresOf(DriveKind::HexOutside, 7.9), 8.0, 1e-9);
  EXPECT_NEAR(millimetresOf(DriveKind::HexOutside, 12.7), 13.0, 1e-9) << "the metric size that fits comes first";
  EXPECT_EQ(keyFor(DriveKind::HexOutside, 42.5e-3), std::nullopt);
}

TEST(KeySizes, InchHexagonsHaveInchKeys) {
  EXPECT_EQ(std::string(keyFor(DriveKind::HexSocket, 4.7625e-3)->inches), "3/16");
  EXPECT_EQ(std::string(keyFor(DriveKind::HexSocket, 6.35e-3)->inches), "1/4");
  EXPECT_EQ(std::string(keyFor(DriveKind::HexSocket, 3.969e-3)->inches), "") << "4 mm is what is at hand";
}

TEST(KeySizes, OnlyHexagonsHaveOne) {
  for (const DriveKind drive : {DriveKind::None, DriveKind::Cross, DriveKind::Slot, DriveKind::SixLobe}) {
    EXPECT_EQ(keyFor(drive, 3e-3), std::nullopt);
  }
  EXPECT_EQ(keyFor(DriveKind::HexSocket, 0.0), std::nullopt);
  EXPECT_EQ(keyFor(DriveKind::HexSocket, std::nan("")), std::nullopt);
}

TEST(KeySizes, NoKeyIsFarFromItsHexagon) {
  for (double across = 0.5; across < 30.0; across += 0.01) {
    if (const double key = millimetresOf(DriveKind::HexSocket, across); key > 0.0) {
      EXPECT_GE(key, 0.96 * across);
      EXPECT_LE(key, 1.012 * across + 1e-9);
    }
  }
}

}  // namespace
}  // namespace glissade
