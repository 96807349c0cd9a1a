#include "widgets/scene3d/camera_steering.h"

#include <gtest/gtest.h>

#include "widgets/scene3d/camera_controller.h"

namespace glissade {
namespace {

class CameraSteering : public testing::Test {
 protected:
  CameraSteering() {
    camera.setStandardView(StandardView::Front);
    camera.fit(Box3(Vector3::Constant(-1.0), Vector3::Constant(1.0)));
  }
  void steer(const Vector3& shift, const Vector3& turn, bool roll = false) {
    steerCamera(camera, {shift, turn}, {1.0, 1.0}, 0.1, roll);
  }

  CameraController camera;
};

TEST_F(CameraSteering, TheSceneFollowsTheHand) {
  const CameraController before = camera;
  steer({1, 0, 0}, Vector3::Zero());
  EXPECT_LT(camera.focus().x(), before.focus().x());  // the scene moves to the right as the camera moves to the left
  EXPECT_EQ(camera.distance(), before.distance());
  steer({0, 1, 0}, Vector3::Zero());
  EXPECT_LT(camera.focus().z(), before.focus().z());
  steer({0, 0, 1}, Vector3::Zero());
  EXPECT_LT(camera.distance(), before.distance());
}

TEST_F(CameraSteering, RollTurnsThePictureWithTheHandAboutTheLineOfSight) {
  const CameraController before = camera;
  const Vector3 right = before.focus() + Vector3::UnitX();
  steer(Vector3::Zero(), {0, 0, 1}, true);
  EXPECT_TRUE(camera.eye().isApprox(before.eye(), 1e-9));
  // The hand turns counter-clockwise, and so does the scene.
  EXPECT_GT((camera.R_WV().conjugate() * (right - camera.eye())).y(), 0.05);
  steer(Vector3::Zero(), {0, 0, -1}, true);
  EXPECT_TRUE(camera.R_WV().isApprox(before.R_WV(), 1e-9));
}

TEST_F(CameraSteering, TurningKeepsTheHorizonLevel) {
  steer(Vector3::Zero(), {0.5, 1.0, 1.0});
  EXPECT_FALSE(camera.R_WV().isApprox(CameraController().R_WV()));
  EXPECT_NEAR((camera.R_WV() * Vector3::UnitX()).z(), 0.0, 1e-12);
}

TEST_F(CameraSteering, ThereAndBackIsWhereItWas) {
  const CameraController before = camera;
  for (const double way : {1.0, -1.0}) steer({way, way, 0}, Vector3::Zero());
  for (const double way : {1.0, -1.0}) steer({0, 0, way}, {0, way, 0});
  EXPECT_TRUE(camera.eye().isApprox(before.eye(), 1e-9));
}

}  // namespace
}  // namespace glissade
