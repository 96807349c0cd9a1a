#include "widgets/scene3d/milestone_drag.h"

#include <cmath>

namespace glissade {
namespace {

/// As the camera's orbit: half a turn over the height of the view.
constexpr double kTurnPerHeight = 3.14159265358979323846;

}  // namespace

std::optional<MilestoneDrag> MilestoneDrag::grip(const CoarsePlan& plan, const MeshPtr& object, const Ray& ray,
                                                 double farthest, const Quaternion& R_WV) {
  std::vector<RigidBody> ghosts;
  std::vector<std::size_t> steps;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    if (!plan.steps[i].milestone || plan.steps[i].border < 0) continue;
    RigidBody ghost;
    ghost.mesh = object;
    ghost.X_WB = plan.steps[i].to;
    ghosts.push_back(std::move(ghost));
    steps.push_back(i);
  }
  const auto hit = pickBody(ghosts, ray);
  if (!hit || hit->distance > farthest) return std::nullopt;
  MilestoneDrag drag;
  drag.step_ = steps[hit->body];
  drag.pose_ = plan.steps[drag.step_].to;
  drag.p_WO_ = drag.pose_.position;
  drag.grip_ = ray.origin + hit->distance * ray.direction;
  drag.R_WV_ = R_WV;
  return drag;
}

void MilestoneDrag::moveTo(const Ray& ray, const SamplingRegion& region) {
  const Vector3 towardsEye = R_WV_ * Vector3::UnitZ();
  const double along = ray.direction.dot(towardsEye);
  if (std::abs(along) < 1e-9) return;
  const double distance = (grip_ - ray.origin).dot(towardsEye) / along;
  if (distance <= 0.0) return;
  const Vector3 point = ray.origin + distance * ray.direction;
  p_WO_ += point - grip_;
  grip_ = point;
  if (region.contains(p_WO_)) pose_.position = p_WO_;
}

void MilestoneDrag::turn(double dx, double dy) {
  const Quaternion about_V = Quaternion(Eigen::AngleAxisd(dx * kTurnPerHeight, Vector3::UnitY())) *
                             Quaternion(Eigen::AngleAxisd(dy * kTurnPerHeight, Vector3::UnitX()));
  pose_.orientation = (R_WV_ * about_V * R_WV_.conjugate() * pose_.orientation).normalized();
}

}  // namespace glissade
