#include "widgets/openxr/text_in_room.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace glissade {
namespace {

const Vector3 kEyes(0.1, 1.6, 0.2);

FlatPicturePtr textOf(int width, int height) {
  auto picture = std::make_shared<FlatPicture>();
  picture->width = width;
  picture->height = height;
  return picture;
}

TEST(TextInRoom, ItFacesTheHeadAndIsUpright) {
  for (const Vector3& p : {Vector3(1.0, 0.5, -2.0), Vector3(-3.0, 2.0, 0.1), Vector3(0.0, 1.6, 5.0)}) {
    const ShownPicture shown = textInRoom(textOf(100, 30), p, kEyes);
    ASSERT_TRUE(shown.X_WP);
    const Quaternion& orientation = shown.X_WP->orientation;
    EXPECT_GT((orientation * Vector3::UnitZ()).dot((kEyes - p).normalized()), 1.0 - 1e-9);
    EXPECT_NEAR((orientation * Vector3::UnitX()).y(), 0.0, 1e-9);
    EXPECT_GT((orientation * Vector3::UnitY()).y(), 0.0);
  }
}

TEST(TextInRoom, CapitalLettersAreMoreThanHalfADegreeHighAtEveryDistance) {
  constexpr double kCapitals = 16.0;  // pixels
  for (const double distance : {0.3, 1.0, 20.0}) {
    const ShownPicture shown = textInRoom(textOf(120, 30), kEyes + Vector3(0.0, 0.0, -distance), kEyes);
    const double degrees = std::atan(kCapitals / 30.0 * shown.height / distance) * 180.0 / std::numbers::pi;
    EXPECT_GT(degrees, 0.5);
    EXPECT_LT(degrees, 0.7);
    EXPECT_NEAR(shown.width, 4.0 * shown.height, 1e-12);
  }
}

TEST(TextInRoom, StraightAboveOrBelowTheHeadItIsAPoseStill) {
  const ShownPicture shown = textInRoom(textOf(10, 10), kEyes + Vector3(0.0, -1.0, 0.0), kEyes);
  ASSERT_TRUE(shown.X_WP);
  EXPECT_TRUE(isValid(*shown.X_WP));
}

TEST(TextInRoom, WithoutAPictureNothingIsShown) { EXPECT_FALSE(textInRoom(nullptr, Vector3::Zero(), kEyes).X_WP); }

}  // namespace
}  // namespace glissade
