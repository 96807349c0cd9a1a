#pragma once

#include "engine/scenario/json_cursor.h"

namespace glissade {

/// Brings a parsed document of any version up to scenario_format::kVersion, one step at a time.
/// Throws JsonFailure for documents that are no scenario or of a version to come.
void migrateScenario(Json& document);

}  // namespace glissade
