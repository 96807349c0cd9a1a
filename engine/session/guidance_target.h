#pragma once

#include <memory>
#include <optional>

#include "engine/base/parameters.h"
#include "engine/operator/guidance.h"
#include "engine/planning/coarse/coarse_plan.h"
#include "engine/planning/path.h"

namespace glissade {

/// The target that attracts the operator at q: a point a little ahead on the path, or without a path the next milestone
/// of the coarse plan; nothing where there is neither. Both may be null.
std::optional<Pose> guidanceTarget(const Path* path, const CoarsePlan* plan, const Pose& q, const Se3Metric& metric);

/// The guidance to this target with the strengths of the parameters.
Guidance guidanceOf(const ParameterValues& parameters, const std::optional<Pose>& target);

}  // namespace glissade
