#include "widgets/scene3d/detail_control.h"

#include <gtest/gtest.h>

#include "widgets/scene3d/camera_controller.h"

namespace glissade {
namespace {

constexpr double kSlow = 1.0;  // seconds of a picture
constexpr double kFast = 1e-4;

TEST(DetailControl, PicturesInMotionBecomeCoarserWhereTheyTakeLongAndFinerAtRest) {
  CameraController camera;
  DetailControl control;
  double tolerance = 0.0;
  for (int i = 0; i < 10; ++i) {
    camera.orbit(0.1, 0.0);
    tolerance = control.begin(camera);
    control.end(kSlow);
  }
  EXPECT_GT(tolerance, 4.0);
  bool isFinerDue = true;
  int pictures = 0;
  for (; isFinerDue && pictures < 10; ++pictures) {
    const double atRest = control.begin(camera);
    EXPECT_LT(atRest, tolerance);
    tolerance = atRest;
    isFinerDue = control.end(kSlow);
  }
  EXPECT_FALSE(isFinerDue);
  EXPECT_EQ(tolerance, 1.0);
}

TEST(DetailControl, FastPicturesStayFine) {
  CameraController camera;
  DetailControl control;
  for (int i = 0; i < 5; ++i) {
    camera.orbit(0.1, 0.0);
    EXPECT_EQ(control.begin(camera), 1.0);
    EXPECT_FALSE(control.end(kFast));
  }
}

}  // namespace
}  // namespace glissade
