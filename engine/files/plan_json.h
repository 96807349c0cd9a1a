#pragma once

#include "engine/base/json_reader.h"
#include "engine/sequence/assembly_plan.h"

namespace glissade {

inline constexpr const char* kPlanFormat = "glissade-plan";

/// Reads the document of planJson(). Private to the readers of this folder. Throws JsonError.
AssemblyPlan readPlanJson(const JsonCursor& at);

}  // namespace glissade
