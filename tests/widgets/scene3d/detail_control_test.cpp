#include "widgets/scene3d/detail_control.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

constexpr double kVerySlow = 1.0;  // seconds of a picture
constexpr double kSlow = 0.06;
constexpr double kFast = 1e-4;

TEST(DetailControl, PicturesOfChangesBecomeCoarserWhereTheyTakeLongAndFinerAtRest) {
  DetailControl control;
  double tolerance = 0.0;
  for (int i = 0; i < 10; ++i) {
    tolerance = control.begin(false).tolerance;
    control.end(kSlow);
  }
  EXPECT_GT(tolerance, 4.0);
  bool isFinerDue = true;
  int pictures = 0;
  for (; isFinerDue && pictures < 10; ++pictures) {
    const PictureDetail atRest = control.begin(true);
    EXPECT_LT(atRest.tolerance, tolerance);
    EXPECT_TRUE(atRest.smooth);
    EXPECT_EQ(atRest.resolution, 1.0);
    tolerance = atRest.tolerance;
    isFinerDue = control.end(kVerySlow);
  }
  EXPECT_FALSE(isFinerDue);
  EXPECT_EQ(tolerance, 1.0);
}

TEST(DetailControl, FastPicturesStayFine) {
  DetailControl control;
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(control.begin(false).tolerance, 1.0);
    EXPECT_FALSE(control.end(kFast));
  }
}

TEST(DetailControl, OnlyPicturesThatTakeLongInSpiteOfFewerTrianglesHaveFewerPixels) {
  DetailControl control;
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(control.begin(false).resolution, 1.0);
    control.end(kSlow);
  }
  for (int i = 0; i < 5; ++i) {
    control.begin(false);
    control.end(kVerySlow);
  }
  EXPECT_LT(control.begin(false).resolution, 1.0);
  EXPECT_FALSE(control.begin(false).smooth);
}

TEST(DetailControl, OneVerySlowPictureMakesTheNextChangeCoarse) {
  DetailControl control;
  control.begin(false);
  control.end(kVerySlow);
  while (control.end(kVerySlow)) control.begin(true);
  EXPECT_GT(control.begin(false).tolerance, 2.0);
}

}  // namespace
}  // namespace glissade
