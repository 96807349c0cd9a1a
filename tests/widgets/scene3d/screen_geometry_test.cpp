#include "widgets/scene3d/screen_geometry.h"

#include <gtest/gtest.h>

#include <random>

#include "widgets/scene3d/scene_pick.h"

namespace glissade {
namespace {

constexpr double kPictureHeight = 0.3;  ///< height on the screen, metres
constexpr double kAspect = 1.6;
const ScreenGeometry kScreen{0.6, 0.7, 0.065};

/// A camera that shows `scale` metres of the scene as one metre of the screen, at the focus.
CameraController cameraFor(double scale) {
  CameraController camera;
  camera.setStandardView(StandardView::Isometric);
  camera.setAspect(kAspect);
  camera.fit(Box3(Vector3(-2.0, -2.0, -2.0), Vector3(2.0, 3.0, 2.0)));
  camera.orbit(0.07, 0.03);
  camera.setFieldOfView(fieldOfView(kScreen, kPictureHeight));
  camera.setViewHeight(scale * kPictureHeight);
  return camera;
}

/// The oracle: the person looks through the screen as through a window at a model of the scene, smaller by `scale`,
/// behind it. Returns the point of the screen on the line from the eye to the point, in metres from the screen's
/// middle, y down.
Eigen::Vector2d throughTheScreen(const CameraController& camera, const Vector3& planePoint, double scale,
                                 const Vector3& eye, const Vector3& p_W) {
  const Quaternion toView = camera.R_WV().conjugate();
  const Vector3 point_V = toView * (p_W - camera.focus());
  const double plane = (toView * (planePoint - camera.focus())).z();
  // The middle of the view, in the plane of the screen, is the middle of the screen.
  const Vector3 model(point_V.x() / scale, point_V.y() / scale, (point_V.z() - plane) / scale);
  const double share = eye.z() / (eye.z() - model.z());
  const Vector3 onScreen = eye + share * (model - eye);
  return {onScreen.x(), -onScreen.y()};
}

class TrueScale : public testing::TestWithParam<double> {};

TEST_P(TrueScale, WhatAnEyeSeesIsAModelOfTheSceneBehindTheScreen) {
  const double scale = GetParam();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> among(-0.05, 0.05);
  for (int i = 0; i < 200; ++i) {
    CameraController camera = cameraFor(scale);
    const HeadPose head{Vector3(among(random), among(random), kScreen.distance + among(random)),
                        Quaternion(Eigen::AngleAxisd(among(random), Vector3::UnitZ()))};
    const Eye eye = i % 2 == 0 ? Eye::Left : Eye::Right;
    camera.setEyePlace(eyePlaceOf(kScreen, kPictureHeight, head, eye));
    const Vector3 p_W = camera.focus() + scale * Vector3(among(random), among(random), among(random));
    const auto drawn = camera.project(p_W);
    ASSERT_TRUE(drawn);
    const Vector3 aside(0.5 * (eye == Eye::Left ? -1.0 : 1.0) * kScreen.eyeSeparation, 0.0, 0.0);
    const Eigen::Vector2d expected =
        throughTheScreen(camera, camera.focus(), scale, head.position + head.orientation * aside, p_W);
    EXPECT_LT((kPictureHeight * *drawn - expected).norm(), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Scales, TrueScale, testing::Values(0.05, 1.0, 8.0));

TEST(ScreenGeometry, WhatIsInThePlaneOfTheScreenIsSeenAtOnePlaceByBothEyes) {
  CameraController camera = cameraFor(2.0);
  const Vector3 plane_W = camera.focus() + camera.R_WV() * Vector3(0.0, 0.0, -0.4);
  std::vector<Eigen::Vector2d> inPlane;
  std::vector<Eigen::Vector2d> before;
  for (const Eye eye : {Eye::Left, Eye::Right}) {
    EyePlace place = eyePlaceOf(kScreen, kPictureHeight, restingHead(kScreen), eye);
    place.plane_W = plane_W;
    camera.setEyePlace(place);
    inPlane.push_back(*camera.project(plane_W + camera.R_WV() * Vector3(0.2, 0.1, 0.0)));
    before.push_back(*camera.project(plane_W + camera.R_WV() * Vector3(0.0, 0.0, 0.3)));
  }
  EXPECT_LT((inPlane[0] - inPlane[1]).norm(), 1e-12);
  EXPECT_GT(before[0].x(), before[1].x() + 1e-3);  // the lines of sight cross before the screen
  EXPECT_NEAR(before[0].y(), before[1].y(), 1e-12);
}

TEST(ScreenGeometry, ARayGoesThroughWhatIsDrawnAtItsPixel) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> among(-0.2, 0.2);
  for (const bool orthographic : {false, true}) {
    CameraController camera = cameraFor(3.0);
    camera.setOrthographic(orthographic);
    for (int i = 0; i < 100; ++i) {
      EyePlace place;
      place.head = Vector3(among(random), among(random), among(random));
      place.eye = Vector3(among(random), 0.0, 0.0);
      if (i % 3 == 0) place.plane_W = Vector3(among(random), among(random), among(random));
      camera.setEyePlace(place);
      const Vector3 p_W(among(random), among(random), among(random));
      const auto drawn = camera.project(p_W);
      ASSERT_TRUE(drawn);
      const Ray ray = rayThrough(camera, drawn->x(), drawn->y());
      const double along = (p_W - ray.origin).dot(ray.direction);
      EXPECT_GT(along, 0.0);
      EXPECT_LT((ray.origin + along * ray.direction - p_W).norm(), 1e-9) << (orthographic ? "parallel" : "perspective");
    }
  }
}

TEST(ScreenGeometry, AHeadThatGoesThroughTheScreenStaysBeforeIt) {
  CameraController camera = cameraFor(1.0);
  EyePlace place;
  place.head = Vector3(0.0, 0.0, -100.0);
  camera.setEyePlace(place);
  EXPECT_GT(camera.magnification(), 0.0);
  EXPECT_GT((camera.R_WV().conjugate() * (camera.eye() - camera.focus())).z(), 0.0);
}

TEST(ScreenGeometry, ThePoseOfACameraDoesNotDependOnTheScreen) {
  CameraController camera;
  camera.fit(Box3(Vector3::Constant(-1.0), Vector3::Constant(1.0)));
  camera.orbit(0.1, 0.1);
  const CameraPose usual = camera.pose();
  const double height = camera.viewHeight();
  camera.setFieldOfView(0.3);
  EXPECT_NEAR(camera.viewHeight(), height, 1e-12);
  EXPECT_NEAR(camera.pose().distance, usual.distance, 1e-12);
  camera.setPose(usual);
  EXPECT_NEAR(camera.viewHeight(), height, 1e-12);
}

}  // namespace
}  // namespace glissade
