#include "engine/model/designation.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

struct Said {
  const char* name;
  StandardPart part;
  const char* text;
  double diameter;  ///< millimetres
  DriveKind drive;
  double size;  ///< millimetres
};

TEST(Designation, StandardsAndAbbreviationsAreReadFromNames) {
  using enum StandardPart;
  const std::vector<Said> all{
      {"ISO 4762 M3x8", Screw, "ISO 4762 M3x8", 3.0, DriveKind::HexSocket, 2.5},
      {"01_02_15-cylinder_screw_M5x80-DIN912", Screw, "DIN 912 M5x80", 5.0, DriveKind::HexSocket, 4.0},
      {"DIN_EN_ISO_4017-M8x30", Screw, "ISO 4017 M8x30", 8.0, DriveKind::HexOutside, 13.0},
      {"DIN 7985 M3 x 10", Screw, "DIN 7985 M3x10", 3.0, DriveKind::Cross, 0.0},
      {"M3x25 SHCS", Screw, "SHCS M3x25", 3.0, DriveKind::HexSocket, 2.5},
      {"Button Head Socket Cap Screw M3_M3 x 12", Screw, "button head M3x12", 3.0, DriveKind::HexSocket, 2.0},
      {"M3x6 BHCS", Screw, "BHCS M3x6", 3.0, DriveKind::HexSocket, 2.0},
      {"Low Profile Screw M5_M5 x 20", Screw, "low profile screw M5x20", 5.0, DriveKind::HexSocket, 3.0},
      {"#10-32 x 0.375\" L BHCS (Steel, Black Oxide)", Screw, "BHCS #10-32x0.375\"", 4.826, DriveKind::HexSocket, 0.0},
      {"M3 Heatset#2", Insert, "heat-set M3", 3.0, DriveKind::None, 0.0},
      {"M3x5x4", Insert, "M3x5x4", 3.0, DriveKind::None, 0.0},
      {"SO-M3-6", Insert, "M3", 3.0, DriveKind::None, 0.0},
      {"Standoff_BSO-M4-10#3", Insert, "M4", 4.0, DriveKind::None, 0.0},
      {"Self-Clinching Nut M3", Insert, "self-clinching M3", 3.0, DriveKind::None, 0.0},
      {"01_01_11-nut_M5-DIN934", Nut, "DIN 934 M5", 5.0, DriveKind::HexOutside, 8.0},
      {"Nylon Insert Lock Nut M5", Nut, "lock nut M5", 5.0, DriveKind::HexOutside, 8.0},
      {"washer_M6-ISO7089", Washer, "ISO 7089 M6", 6.0, DriveKind::None, 0.0},
      {"ISO 2338 - 4 x 20", Pin, "ISO 2338", 0.0, DriveKind::None, 0.0},
      {"608ZZ", Bearing, "608ZZ", 0.0, DriveKind::None, 0.0},
      {"bearing 623", Bearing, "623", 0.0, DriveKind::None, 0.0},
      {"M8x1.25x30 hex bolt", Screw, "hex bolt M8x1.25x30", 8.0, DriveKind::HexOutside, 13.0}};
  for (const Said& said : all) {
    const auto found = designationIn(said.name);
    ASSERT_TRUE(found) << said.name;
    EXPECT_EQ(found->part, said.part) << said.name;
    EXPECT_EQ(found->text, said.text);
    EXPECT_NEAR(found->diameter, 1e-3 * said.diameter, 1e-9) << said.name;
    EXPECT_EQ(found->drive, said.drive) << said.name;
    EXPECT_NEAR(found->driveSize, 1e-3 * said.size, 1e-9) << said.name;
  }
}

TEST(Designation, OtherNamesSayNothing) {
  for (const char* name : {"plate", "Part 3", "rod", "arm 6mm", "2020 extrusion", "X44", "", "Bracket M"}) {
    EXPECT_FALSE(designationIn(name)) << name;
  }
  EXPECT_FALSE(designationIn(std::string(100000, 'M')));
}

TEST(Designation, AnUnknownStandardThatAPersonSaysIsAnError) {
  EXPECT_TRUE(designationOf("ISO 4762 M3x8"));
  for (const char* text : {"ISO 99999 M3", "DIN 1 M3x8", "something"}) {
    const auto said = designationOf(text);
    ASSERT_FALSE(said) << text;
    EXPECT_EQ(said.error().kind, ErrorKind::Usage);
  }
}

TEST(Designation, LengthAndPitch) {
  const auto fine = designationIn("M8x1.25x30 hex bolt");
  ASSERT_TRUE(fine);
  EXPECT_NEAR(fine->length, 0.03, 1e-9);
  EXPECT_NEAR(fine->pitch, 0.00125, 1e-9);
  const auto inch = designationIn("#10-32 BHCS");
  ASSERT_TRUE(inch);
  EXPECT_NEAR(inch->pitch, 0.0254 / 32.0, 1e-9);
  EXPECT_EQ(inch->length, 0.0);
  const std::vector<std::pair<const char*, double>> inches{{"#10-32 x 1-1/4\" L BHCS", 1.25},
                                                           {"#10-32 x 1/2\" L BHCS", 0.5},
                                                           {"1/4-20 x 3/4 hex bolt", 0.75},
                                                           {"#8-32 x 2 SHCS", 2.0},
                                                           {"#8-32 x .5 SHCS", 0.5}};
  for (const auto& [name, length] : inches) {
    const auto said = designationIn(name);
    ASSERT_TRUE(said) << name;
    EXPECT_NEAR(said->length, 0.0254 * length, 1e-9) << name << ": " << said->text;
  }
}

}  // namespace
}  // namespace glissade
