#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/planning/coarse/scene_knowledge.h"

namespace glissade::cli {

/// Octree, places and borders, for people and for programs.
void printEnvironment(const SceneKnowledge& knowledge, const SemanticModel& semantics);
nlohmann::ordered_json toJson(const SceneKnowledge& knowledge, const SemanticModel& semantics);

}  // namespace glissade::cli
