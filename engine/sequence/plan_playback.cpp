#include "engine/sequence/plan_playback.h"

#include <algorithm>

#include "engine/sequence/plan_bodies.h"

namespace glissade {
PlanPlayback::PlanPlayback(const AssembledProduct& product, const AssemblyPlan& plan) : bodies_(product.bodies.size()) {
  for (const AssemblyStep& step : plan.steps) {
    const std::vector<std::size_t> bodies = bodiesOf(step, product);
    steps_.push_back({bodies, StepWay(step, product.bodies[bodies.front()])});
  }
}

std::vector<PlayedBody> PlanPlayback::at(double time) const {
  std::vector<PlayedBody> bodies(bodies_);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const double share = std::clamp(time - static_cast<double>(i), 0.0, 1.0);
    if (share == 0.0) break;
    const Pose moved = steps_[i].way.movedAt(share * steps_[i].way.length());
    for (const std::size_t body : steps_[i].bodies) bodies[body] = {moved, share == 1.0, share < 1.0};
  }
  return bodies;
}

}  // namespace glissade
