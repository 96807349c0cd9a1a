#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/cli/report.h"
#include "engine/files/scenario.h"
#include "engine/planning/coarse/scene_knowledge.h"

namespace glissade::cli {

/// Octree, places and borders, for people and for programs.
void printEnvironment(const SceneKnowledge& knowledge, const SemanticModel& semantics, const Console& console);
nlohmann::ordered_json toJson(const SceneKnowledge& knowledge, const SemanticModel& semantics);
/// Prints to stderr which edits of places and milestones have no effect or not the intended one.
void warnOfEdits(const LoadedScenario& scenario, const SceneKnowledge& knowledge, const Console& console);

}  // namespace glissade::cli
