#pragma once

#include <memory>
#include <optional>

#include "engine/base/parameters.h"
#include "engine/operator/guidance.h"
#include "engine/planning/coarse/coarse_plan.h"
#include "engine/planning/path.h"

namespace glissade {

/// Where the operator is drawn from q: a little ahead on the path once there is one, before that the next
/// milestone of the coarse plan; nothing where there is neither. Both may be null.
std::optional<Pose> guidanceTarget(const Path* path, const CoarsePlan* plan, const Pose& q, const Se3Metric& metric);

/// The guidance that the parameters ask for, to this target.
Guidance guidanceOf(const ParameterValues& parameters, const std::optional<Pose>& target);

}  // namespace glissade
