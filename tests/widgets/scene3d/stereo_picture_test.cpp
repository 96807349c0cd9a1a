#include "widgets/scene3d/stereo_picture.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

constexpr int kWidth = 8;
constexpr int kHeight = 6;
const QRgb kOfLeft = qRgb(200, 30, 60);
const QRgb kOfRight = qRgb(10, 150, 90);

QImage filled(QRgb colour) {
  QImage picture(kWidth, kHeight, QImage::Format_RGBX8888);
  picture.fill(QColor(colour));
  return picture;
}

QImage composed(StereoMode mode, const QPoint& corner = {}) {
  return composeStereo(mode, filled(kOfLeft), filled(kOfRight), corner);
}

/// The pixels row by row: those of the left eye as 'l', those of the right eye as 'r', others as '?'.
std::string owners(const QImage& picture) {
  std::string owners;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const QRgb pixel = picture.pixel(x, y);
      owners += pixel == kOfLeft ? 'l' : pixel == kOfRight ? 'r' : '?';
    }
    owners += ' ';
  }
  return owners;
}

TEST(StereoPicture, AnaglyphHasTheRedOfTheLeftEyeAndTheRestOfTheRightOne) {
  EXPECT_EQ(composed(StereoMode::Anaglyph).pixel(3, 3), qRgb(200, 150, 90));
}

TEST(StereoPicture, EachModeGivesEachEyeItsPixels) {
  EXPECT_EQ(owners(composed(StereoMode::SideBySide)), "llllrrrr llllrrrr llllrrrr llllrrrr llllrrrr llllrrrr ");
  EXPECT_EQ(owners(composed(StereoMode::TopBottom)), "llllllll llllllll llllllll rrrrrrrr rrrrrrrr rrrrrrrr ");
  EXPECT_EQ(owners(composed(StereoMode::Interlaced)), "llllllll rrrrrrrr llllllll rrrrrrrr llllllll rrrrrrrr ");
  EXPECT_EQ(owners(composed(StereoMode::Checkerboard)), "lrlrlrlr rlrlrlrl lrlrlrlr rlrlrlrl lrlrlrlr rlrlrlrl ");
  EXPECT_EQ(owners(composed(StereoMode::LeftEye)).find('r'), std::string::npos);
  EXPECT_EQ(owners(composed(StereoMode::RightEye)).find('l'), std::string::npos);
}

/// A window that is moved by one row still gives each eye the screen's rows for it.
TEST(StereoPicture, WhatIsInterlacedFollowsTheScreen) {
  EXPECT_EQ(composed(StereoMode::Interlaced, {0, 1}).pixel(0, 0), kOfRight);
  EXPECT_EQ(composed(StereoMode::Checkerboard, {1, 0}).pixel(0, 0), kOfRight);
  EXPECT_EQ(composed(StereoMode::Checkerboard, {1, 1}).pixel(0, 0), kOfLeft);
}

TEST(StereoPicture, PixelsOfAFineDisplayAreNotScaled) {
  QImage left = filled(kOfLeft);
  QImage right = filled(kOfRight);
  for (QImage* picture : {&left, &right}) picture->setDevicePixelRatio(2.0);
  const QImage picture = composeStereo(StereoMode::SideBySide, left, right, {});
  EXPECT_EQ(picture.size(), left.size());
  EXPECT_EQ(picture.pixel(kWidth - 1, kHeight - 1), kOfRight);
}

TEST(StereoPicture, APointBelongsToTheEyeWhosePartItIsIn) {
  const QSizeF size(100, 80);
  const EyePoint left = eyePointAt(StereoMode::SideBySide, {20, 30}, size);
  EXPECT_EQ(left.eye, Eye::Left);
  EXPECT_EQ(left.at, QPointF(40, 30));
  const EyePoint right = eyePointAt(StereoMode::SideBySide, {70, 30}, size);
  EXPECT_EQ(right.eye, Eye::Right);
  EXPECT_EQ(right.at, QPointF(40, 30));
  const EyePoint below = eyePointAt(StereoMode::TopBottom, {20, 50}, size);
  EXPECT_EQ(below.eye, Eye::Right);
  EXPECT_EQ(below.at, QPointF(20, 20));
  EXPECT_EQ(eyePointAt(StereoMode::Anaglyph, {70, 50}, size).at, QPointF(70, 50));
  // A drag that leaves its part continues in the picture of its eye.
  EXPECT_EQ(pointOfEye(StereoMode::SideBySide, Eye::Left, {70, 30}, size), QPointF(140, 30));
}

TEST(StereoPicture, ModesAreFoundByTheirNames) {
  for (const StereoModeEntry& entry : kStereoModes) {
    EXPECT_EQ(stereoModeNamed(entry.name), entry.mode);
    EXPECT_EQ(&entryOf(entry.mode), &entry);
  }
  EXPECT_EQ(stereoModeNamed("mono"), std::nullopt);
}

}  // namespace
}  // namespace glissade
