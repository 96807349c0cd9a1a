#include "widgets/scene3d/pose_drag.h"

#include <cmath>
#include <numbers>

namespace glissade {
namespace {

/// The angle of the camera's orbit: half a turn over the height of the view.
constexpr double kBodyTurnPerHeight = std::numbers::pi;

}  // namespace

void PoseDrag::moveTo(const Ray& ray) {
  const Vector3 towardsEye = R_WV_ * Vector3::UnitZ();
  const double along = ray.direction.dot(towardsEye);
  if (std::abs(along) < 1e-9) return;
  const double distance = (grip_ - ray.origin).dot(towardsEye) / along;
  if (distance <= 0.0) return;
  const Vector3 point = ray.origin + distance * ray.direction;
  X_WB_.position += point - grip_;
  grip_ = point;
}

void PoseDrag::turn(double dx, double dy) {
  const Quaternion about_V = Quaternion(Eigen::AngleAxisd(dx * kBodyTurnPerHeight, Vector3::UnitY())) *
                             Quaternion(Eigen::AngleAxisd(dy * kBodyTurnPerHeight, Vector3::UnitX()));
  X_WB_.orientation = (R_WV_ * about_V * R_WV_.conjugate() * X_WB_.orientation).normalized();
}

}  // namespace glissade
