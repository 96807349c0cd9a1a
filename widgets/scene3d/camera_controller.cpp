#include "widgets/scene3d/camera_controller.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glissade {
namespace {

constexpr double kFieldOfView = 35.0 * std::numbers::pi / 180.0;
/// Angle by which a drag over the view's height turns.
constexpr double kCameraTurnPerHeight = std::numbers::pi;
/// The eye comes no nearer to the focus than this share of the scene's radius.
constexpr double kNearestShare = 1e-3;
/// Share of its way to a followed point that the focus moves at each picture.
constexpr double kFollowShare = 0.1;
/// Least distance of the picture from the eye straight before it, as a share of the focus's distance. It is also the
/// least distance of an eye from the picture, as a share of the picture's distance.
constexpr double kNearestPicture = 0.1;

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
  showFitted();
}

void CameraController::showFitted() {
  focus_ = fitted_->center();
  distance_ = distanceFor(*fitted_);
}

void CameraController::zoomTo(const Box3& box, double coveredBelow) {
  if (box.isEmpty()) return;
  fitted_.reset();
  focus_ = box.center();
  distance_ = std::max(distanceFor(box), kNearestShare * sceneRadius_) / (1.0 - coveredBelow);
  const double halfHeight = distance_ * std::tan(0.5 * fieldOfView_);
  focus_ -= coveredBelow * halfHeight * (orientation_ * Vector3::UnitY());
}

/// The least distance from which every corner of a box about the focus is in view.
double CameraController::distanceFor(const Box3& box) const {
  const double tanV = std::tan(0.5 * fieldOfView_);
  const double tanH = tanV * aspect_;
  const Quaternion toView = orientation_.conjugate();
  double needed = 1e-6;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3 p = toView * (box.corner(static_cast<Box3::CornerType>(corner)) - focus_);
    const double nearer = orthographic_ ? 0.0 : p.z();
    needed = std::max({needed, nearer + std::abs(p.y()) / tanV, nearer + std::abs(p.x()) / tanH});
  }
  return 1.05 * needed;
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

void CameraController::lookFrom(const Vector3& towardsEye) {
  const Vector3 direction = towardsEye.normalized();
  constexpr double kVertical = 0.999;
  const bool vertical = std::abs(direction.z()) > kVertical;
  orientation_ = viewAlong(direction, vertical ? Vector3::UnitY() : Vector3::UnitZ());
}

double CameraController::usualFieldOfView() { return kFieldOfView; }

CameraPose CameraController::pose() const {
  const double usual = distance_ * std::tan(0.5 * fieldOfView_) / std::tan(0.5 * kFieldOfView);
  return {focus_, orientation_, usual, orthographic_};
}

void CameraController::setFieldOfView(double vertical) {
  if (vertical == fieldOfView_) return;
  distance_ *= std::tan(0.5 * fieldOfView_) / std::tan(0.5 * vertical);
  fieldOfView_ = vertical;
  if (fitted_) showFitted();
}

void CameraController::setViewHeight(double metres) {
  fitted_.reset();
  distance_ = 0.5 * metres / std::tan(0.5 * fieldOfView_);
}

void CameraController::setPose(const CameraPose& pose) {
  fitted_.reset();
  focus_ = pose.focus;
  orientation_ = pose.R_WV.normalized();
  distance_ = pose.distance * std::tan(0.5 * kFieldOfView) / std::tan(0.5 * fieldOfView_);
  orthographic_ = pose.orthographic;
}

void CameraController::setOrthographic(bool orthographic) {
  if (orthographic == orthographic_) return;
  orthographic_ = orthographic;
  if (fitted_) showFitted();
}

void CameraController::enclose(const Box3& box) {
  for (int corner = 0; corner < 8 && !box.isEmpty(); ++corner) {
    const Vector3 p = box.corner(static_cast<Box3::CornerType>(corner));
    sceneRadius_ = std::max(sceneRadius_, (p - sceneCentre_).norm());
  }
}

void CameraController::orbit(double dx, double dy) {
  fitted_.reset();
  // The camera turns about the world's vertical and the view's own horizontal, so that the horizon stays level.
  const Quaternion yaw(Eigen::AngleAxisd(-dx * kCameraTurnPerHeight, Vector3::UnitZ()));
  const Quaternion pitch(Eigen::AngleAxisd(-dy * kCameraTurnPerHeight, Vector3::UnitX()));
  orientation_ = (yaw * orientation_ * pitch).normalized();
}

void CameraController::tumble(double dx, double dy) {
  fitted_.reset();
  const Quaternion yaw(Eigen::AngleAxisd(-dx * kCameraTurnPerHeight, Vector3::UnitY()));
  const Quaternion pitch(Eigen::AngleAxisd(-dy * kCameraTurnPerHeight, Vector3::UnitX()));
  orientation_ = (orientation_ * yaw * pitch).normalized();
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
  distance_ = std::clamp(distance_ / factor, kNearestShare * sceneRadius_, 50.0 * sceneRadius_);
  // Keeps the point of the focal plane under the pointer in place.
  const double moved = 2.0 * (before - distance_) * std::tan(0.5 * fieldOfView_);
  focus_ += orientation_ * Vector3(x * moved, -y * moved, 0.0);
}

void CameraController::follow(const Vector3& from, const Vector3& to) {
  fitted_.reset();
  focus_ += (to - from) + kFollowShare * (from - focus_);
}

void CameraController::setAspect(double widthOverHeight) {
  if (widthOverHeight <= 0.0 || widthOverHeight == aspect_) return;
  aspect_ = widthOverHeight;
  if (fitted_) showFitted();
}

Quaternion CameraController::R_WV() const { return orientation_; }

/// The eye straight before the middle of the picture.
Vector3 CameraController::middleEye() const { return focus_ + orientation_ * Vector3(0.0, 0.0, distance_); }

/// Distance from middleEye() to the plane of the picture.
double CameraController::pictureDistance() const {
  if (!eyePlace_.plane_W) return distance_;
  const double depth = -(orientation_.conjugate() * (*eyePlace_.plane_W - middleEye())).z();
  return std::max(depth, kNearestPicture * distance_);
}

/// Height of the picture in its plane, metres.
double CameraController::pictureHeight() const {
  return orthographic_ ? viewHeight() : 2.0 * pictureDistance() * std::tan(0.5 * fieldOfView_);
}

/// The eye from middleEye(), in the view frame, metres of the scene.
Vector3 CameraController::eyeOffset() const {
  Vector3 offset = pictureHeight() * (eyePlace_.head + eyePlace_.eye);
  offset.z() = std::max(offset.z(), (kNearestPicture - 1.0) * pictureDistance());
  return offset;
}

Vector3 CameraController::eye() const { return focus_ + orientation_ * (Vector3(0.0, 0.0, distance_) + eyeOffset()); }

double CameraController::viewHeight() const { return 2.0 * distance_ * std::tan(0.5 * fieldOfView_); }

double CameraController::magnification() const {
  return orthographic_ ? 1.0 : (pictureDistance() + eyeOffset().z()) / pictureDistance();
}

Eigen::Vector2d CameraController::shift() const {
  const Vector3 offset = eyeOffset();
  const double perMetre = orthographic_ ? 1.0 / (pictureDistance() + offset.z()) : 1.0;
  return offset.head<2>() * perMetre / pictureHeight();
}

double CameraController::viewHeightAt(const Vector3& p_W) const {
  if (orthographic_) return viewHeight();
  const double depth = -(orientation_.conjugate() * (p_W - eye())).z();
  return 2.0 * std::max(depth, nearPlane()) * std::tan(0.5 * fieldOfView_) / magnification();
}

double CameraController::nearPlane() const {
  if (orthographic_) return toCentre() - 2.0 * sceneRadius_;
  const double toScene = (eye() - sceneCentre_).norm() - 2.0 * sceneRadius_;
  return std::max(toScene, 1e-3 * farPlane());
}

double CameraController::farPlane() const {
  if (orthographic_) return toCentre() + 2.0 * sceneRadius_;
  return (eye() - sceneCentre_).norm() + 2.0 * sceneRadius_;
}

/// Distance from the eye to the middle of the scene, along the line of sight.
double CameraController::toCentre() const { return (orientation_.conjugate() * (eye() - sceneCentre_)).z(); }

std::optional<Eigen::Vector2d> CameraController::project(const Vector3& p_W) const {
  const Vector3 p_V = orientation_.conjugate() * (p_W - eye());
  if (p_V.z() > -nearPlane()) return std::nullopt;
  const double height = viewHeightAt(p_W);
  const Eigen::Vector2d shifted = orthographic_ ? Eigen::Vector2d(-p_V.z() * shift()) : shift();
  return Eigen::Vector2d(p_V.x() / height + shifted.x(), -p_V.y() / height - shifted.y());
}

}  // namespace glissade
