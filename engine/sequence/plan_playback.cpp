#include "engine/sequence/plan_playback.h"

#include <algorithm>
#include <utility>

namespace glissade {

double PlayedMotion::time(const AssemblyPlan& plan) const {
  const auto motions = static_cast<double>(plan.steps[step].motions.size());
  return static_cast<double>(step) + (static_cast<double>(motion) + share) / motions;
}

PlayedMotion playedMotionAt(double time, const AssemblyPlan& plan) {
  PlayedMotion played;
  played.step = static_cast<std::size_t>(time);
  const std::size_t motions = plan.steps[played.step].motions.size();
  const double done = (time - static_cast<double>(played.step)) * static_cast<double>(motions);
  played.motion = std::min(motions - 1, static_cast<std::size_t>(done));
  played.share = done - static_cast<double>(played.motion);
  return played;
}

PlanPlayback::PlanPlayback(const AssembledProduct& product, const AssemblyPlan& plan) : bodies_(product.bodies.size()) {
  for (const AssemblyStep& step : plan.steps) {
    steps_.emplace_back();
    for (const StepMotion& motion : step.motions) {
      std::vector<std::size_t> bodies = product.indicesOf(motion.bodies());
      const StepWay way(motion, product.bodies[bodies.front()]);
      steps_.back().push_back({std::move(bodies), way});
    }
  }
}

std::vector<PlayedBody> PlanPlayback::at(double time) const {
  std::vector<PlayedBody> bodies(bodies_);
  double begin = 0.0;
  for (const std::vector<Motion>& motions : steps_) {
    const double duration = 1.0 / static_cast<double>(motions.size());
    for (std::size_t i = 0; i < motions.size(); ++i) {
      const double share = std::clamp((time - begin) / duration - static_cast<double>(i), 0.0, 1.0);
      if (share == 0.0) return bodies;
      const Pose moved = motions[i].way.movedAt(share * motions[i].way.length());
      for (const std::size_t body : motions[i].bodies) bodies[body] = {moved, share == 1.0, share < 1.0};
    }
    begin += 1.0;
  }
  return bodies;
}

}  // namespace glissade
