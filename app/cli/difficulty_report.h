#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/cli/report.h"
#include "engine/base/stop_token.h"
#include "engine/planning/difficulty/difficulty.h"
#include "engine/scenario/scenario.h"
#include "engine/session/session.h"

namespace glissade::cli {

/// Why the run found no path, from the roadmap that it grew.
Difficulty difficultyOf(const LoadedScenario& scenario, const SessionSnapshot& end, const StopToken& stop);

nlohmann::ordered_json toJson(const Difficulty& difficulty, const CollisionWorld& world);
void printDifficulty(const Difficulty& difficulty, const CollisionWorld& world, const Console& console);

}  // namespace glissade::cli
