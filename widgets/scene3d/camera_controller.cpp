#include "widgets/scene3d/camera_controller.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glissade {
namespace {

constexpr double kFieldOfView = 35.0 * std::numbers::pi / 180.0;
/// Drag over the view's height turns by this much.
constexpr double kCameraTurnPerHeight = std::numbers::pi;

/// The view frame that looks along -z_V with y_V up.
Quaternion viewAlong(const Vector3& toEye, const Vector3& up) {
  Eigen::Matrix3d R;
  R.col(2) = toEye.normalized();
  R.col(0) = up.cross(R.col(2)).normalized();
  R.col(1) = R.col(2).cross(R.col(0));
  return Quaternion(R);
}

}  // namespace

void CameraController::fit(const Box3& box) {
  if (box.isEmpty()) return;
  fitted_ = box;
  sceneCentre_ = box.center();
  sceneRadius_ = std::max(1e-6, 0.5 * box.diagonal().norm());
  focus_ = sceneCentre_;
  // The nearest distance from which every corner is inside the frustum.
  const double tanV = std::tan(0.5 * kFieldOfView);
  const double tanH = tanV * aspect_;
  const Quaternion toView = orientation_.conjugate();
  double needed = 1e-6;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3 p = toView * (box.corner(static_cast<Box3::CornerType>(corner)) - focus_);
    needed = std::max({needed, p.z() + std::abs(p.y()) / tanV, p.z() + std::abs(p.x()) / tanH});
  }
  distance_ = 1.05 * needed;
}

void CameraController::setStandardView(StandardView view) {
  const Vector3 z = Vector3::UnitZ();
  switch (view) {
    case StandardView::Front: orientation_ = viewAlong(-Vector3::UnitY(), z); break;
    case StandardView::Back: orientation_ = viewAlong(Vector3::UnitY(), z); break;
    case StandardView::Left: orientation_ = viewAlong(-Vector3::UnitX(), z); break;
    case StandardView::Right: orientation_ = viewAlong(Vector3::UnitX(), z); break;
    case StandardView::Top: orientation_ = viewAlong(z, Vector3::UnitY()); break;
    case StandardView::Bottom: orientation_ = viewAlong(-z, Vector3::UnitY()); break;
    case StandardView::Isometric: orientation_ = viewAlong({-1.0, -1.2, 0.9}, z); break;
  }
}

void CameraController::setDirection(const Vector3& toEye) { orientation_ = viewAlong(toEye, Vector3::UnitZ()); }

void CameraController::enclose(const Box3& box) {
  for (int corner = 0; corner < 8 && !box.isEmpty(); ++corner) {
    const Vector3 p = box.corner(static_cast<Box3::CornerType>(corner));
    sceneRadius_ = std::max(sceneRadius_, (p - sceneCentre_).norm());
  }
}

void CameraController::orbit(double dx, double dy) {
  fitted_.reset();
  // About the world's vertical and the view's own horizontal: the horizon stays level.
  const Quaternion yaw(Eigen::AngleAxisd(-dx * kCameraTurnPerHeight, Vector3::UnitZ()));
  const Quaternion pitch(Eigen::AngleAxisd(-dy * kCameraTurnPerHeight, Vector3::UnitX()));
  orientation_ = (yaw * orientation_ * pitch).normalized();
}

void CameraController::roll(double angle) {
  fitted_.reset();
  orientation_ = (orientation_ * Quaternion(Eigen::AngleAxisd(angle, Vector3::UnitZ()))).normalized();
}

void CameraController::pan(double dx, double dy) {
  fitted_.reset();
  focus_ += viewHeight() * (orientation_ * Vector3(-dx, dy, 0.0));
}

void CameraController::zoom(double factor, double x, double y) {
  fitted_.reset();
  const double before = distance_;
  distance_ = std::clamp(distance_ / factor, 1e-3 * sceneRadius_, 50.0 * sceneRadius_);
  // The point of the focal plane under the pointer stays there.
  const double moved = 2.0 * (before - distance_) * std::tan(0.5 * kFieldOfView);
  focus_ += orientation_ * Vector3(x * moved, -y * moved, 0.0);
}

void CameraController::setAspect(double widthOverHeight) {
  if (widthOverHeight <= 0.0 || widthOverHeight == aspect_) return;
  aspect_ = widthOverHeight;
  if (fitted_) fit(Box3(*fitted_));
}

Quaternion CameraController::R_WV() const { return orientation_; }

Vector3 CameraController::eye() const { return focus_ + orientation_ * Vector3(0.0, 0.0, distance_); }

double CameraController::verticalFieldOfView() const { return kFieldOfView; }

double CameraController::viewHeight() const { return 2.0 * distance_ * std::tan(0.5 * kFieldOfView); }

double CameraController::nearPlane() const {
  const double toScene = (eye() - sceneCentre_).norm() - 2.0 * sceneRadius_;
  return std::max(toScene, 1e-3 * farPlane());
}

double CameraController::farPlane() const { return (eye() - sceneCentre_).norm() + 2.0 * sceneRadius_; }

}  // namespace glissade
