#pragma once

#include "engine/scenario/scenario.h"

namespace glissade {

/// Start and (where it is a configuration) goal are free. Else InCollision, with "start" or "goal"
/// as place and the names of the object and of the body it touches or penetrates.
Outcome checkStartAndGoal(const LoadedScenario& scenario);

}  // namespace glissade
