#include "engine/sequence/plan_playback.h"

#include <algorithm>

#include "engine/sequence/plan_bodies.h"

namespace glissade {
namespace {

double radiusOf(const RigidBody& body) { return std::max(1e-9, 0.5 * boundingBox(*body.mesh).diagonal().norm()); }

}  // namespace

PlanPlayback::PlanPlayback(const AssembledProduct& product, const AssemblyPlan& plan) : bodies_(product.bodies.size()) {
  for (const AssemblyStep& planned : plan.steps) {
    Step step;
    step.bodies = bodiesOf(planned, product);
    const Se3Metric metric(radiusOf(product.bodies[step.bodies.front()]));
    for (const PathPoint& point : planned.path) {
      const double way = step.way.empty() ? 0.0 : step.arrival.back() + metric.distance(step.way.back(), point.q);
      step.way.push_back(point.q);
      step.arrival.push_back(way);
    }
    steps_.push_back(std::move(step));
  }
}

Pose PlanPlayback::moved(const Step& step, double share) {
  const auto along = [&](double way) {
    if (step.way.size() < 2) return step.way.front();
    const auto after = std::upper_bound(step.arrival.begin() + 1, step.arrival.end() - 1, way);
    const auto i = static_cast<std::size_t>(after - step.arrival.begin());
    const double length = step.arrival[i] - step.arrival[i - 1];
    return interpolate(step.way[i - 1], step.way[i], length > 0.0 ? (way - step.arrival[i - 1]) / length : 1.0);
  };
  return along(share * step.arrival.back()) * inverse(step.way.front());
}

std::vector<PlayedBody> PlanPlayback::at(double time) const {
  std::vector<PlayedBody> bodies(bodies_);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const double share = std::clamp(time - static_cast<double>(i), 0.0, 1.0);
    if (share == 0.0) break;
    for (const std::size_t body : steps_[i].bodies) bodies[body] = {moved(steps_[i], share), share == 1.0, share < 1.0};
  }
  return bodies;
}

}  // namespace glissade
