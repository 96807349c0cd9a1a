#pragma once

#include <glissade/planners.h>

#include "engine/planning/planner.h"

namespace glissade::api {

/// The registry's entry of a planner from outside. What the function returns is certified as the paths of all other
/// planners are.
PlannerEntry entryOf(const Planners::Entry& outside);

}  // namespace glissade::api
