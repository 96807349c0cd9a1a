#include "engine/session/guidance_target.h"

namespace glissade {
namespace {

/// Distance of the target on a path ahead of the hand, in radii of the object.
constexpr double kAhead = 0.5;

}  // namespace

std::optional<Pose> guidanceTarget(const Path* path, const CoarsePlan* plan, const Pose& q, const Se3Metric& metric) {
  if (path != nullptr) return aheadOnWay(path->configurations(), q, metric, kAhead * metric.radius());
  if (plan == nullptr) return std::nullopt;
  for (const TopologicalStep& step : plan->steps) {
    if (step.result != StepResult::Solved) return step.milestone ? std::make_optional(step.to) : std::nullopt;
  }
  return std::nullopt;
}

Guidance guidanceOf(const ParameterValues& parameters, const std::optional<Pose>& target) {
  return {parameters[ParameterId::GuidanceRepulsion], parameters[ParameterId::GuidanceAttraction],
          parameters[ParameterId::ContactDistance], target};
}

}  // namespace glissade
