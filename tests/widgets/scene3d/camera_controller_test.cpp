#include "widgets/scene3d/camera_controller.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

const Box3 kWide(Vector3(-3.0, -1.0, -1.0), Vector3(3.0, 1.0, 1.0));

TEST(CameraController, WhatWasFittedStaysInViewWhateverShapeTheViewTakes) {
  CameraController camera;
  camera.setStandardView(StandardView::Front);
  camera.fit(kWide);
  const double wide = camera.distance();
  camera.setAspect(0.5);
  EXPECT_GT(camera.distance(), 2.0 * wide);
  EXPECT_GT(camera.aspect() * camera.viewHeight(), kWide.sizes().x());
  camera.setAspect(16.0 / 9.0);
  EXPECT_DOUBLE_EQ(camera.distance(), wide);
}

TEST(CameraController, ACameraThatWasMovedIsLeftAlone) {
  const auto moves = {
      +[](CameraController& camera) { camera.orbit(0.1, 0.0); }, +[](CameraController& camera) { camera.roll(0.1); },
      +[](CameraController& camera) { camera.pan(0.1, 0.0); }, +[](CameraController& camera) { camera.zoom(1.1); }};
  for (const auto& move : moves) {
    CameraController camera;
    camera.fit(kWide);
    move(camera);
    const double moved = camera.distance();
    camera.setAspect(0.5);
    EXPECT_EQ(camera.distance(), moved);
  }
}

TEST(CameraController, PlanesHoldWhatIsEnclosedWhateverShapeTheViewTakes) {
  CameraController camera;
  camera.setStandardView(StandardView::Front);
  camera.fit(kWide);
  camera.enclose(Box3(Vector3::Constant(-30.0), Vector3::Constant(30.0)));
  camera.setAspect(0.5);
  EXPECT_GT(camera.farPlane(), camera.distance() + 30.0);
  EXPECT_TRUE(camera.isFitted());
}

TEST(CameraController, APointThatIsFollowedComesToTheMiddle) {
  CameraController camera;
  camera.fit(kWide);
  const double distance = camera.distance();
  Vector3 point(1.0, 0.0, 0.0);
  for (int i = 0; i < 100; ++i) {
    const Vector3 next = point + Vector3(0.0, 0.05, 0.0);
    camera.follow(point, next);
    point = next;
  }
  EXPECT_LT((camera.focus() - point).norm(), 0.01);
  EXPECT_EQ(camera.distance(), distance);
}

TEST(CameraController, WhatIsZoomedToIsAboveWhatCoversTheLowerBorder) {
  constexpr double kCovered = 0.3;
  for (const StandardView view : {StandardView::Front, StandardView::Top, StandardView::Isometric}) {
    CameraController camera;
    camera.fit(kWide);
    camera.setStandardView(view);
    camera.zoomTo(kWide, kCovered);
    for (int corner = 0; corner < 8; ++corner) {
      const auto at = camera.project(kWide.corner(static_cast<Box3::CornerType>(corner)));
      ASSERT_TRUE(at.has_value());
      EXPECT_LT(at->y(), 0.5 - kCovered);
      EXPECT_GT(at->y(), -0.5);
    }
  }
}

}  // namespace
}  // namespace glissade
