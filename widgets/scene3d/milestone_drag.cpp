#include "widgets/scene3d/milestone_drag.h"

namespace glissade {

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
  const std::size_t step = steps[hit->body];
  return MilestoneDrag(step, PoseDrag(plan.steps[step].to, ray.origin + hit->distance * ray.direction, R_WV));
}

void MilestoneDrag::moveTo(const Ray& ray, const SamplingRegion& region) {
  drag_.moveTo(ray);
  if (region.contains(drag_.pose().position)) pose_.position = drag_.pose().position;
}

void MilestoneDrag::turn(double dx, double dy) {
  drag_.turn(dx, dy);
  pose_.orientation = drag_.pose().orientation;
}

}  // namespace glissade
