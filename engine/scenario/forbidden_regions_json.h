#pragma once

#include "engine/import/json_reader.h"
#include "engine/scenario/scenario.h"

namespace glissade {

/// What a scenario file says of forbidden places by boxes, beside the edits that forbid them: who has no environment
/// model reads these. Private to the readers and writers of this room. Reading throws JsonError.
void readForbiddenRegions(const JsonCursor& root, Scenario& scenario);
/// Adds "forbidden_regions" where there are some.
void addForbiddenRegions(const ForbiddenPlaces& places, JsonCursor::Json& json);

}  // namespace glissade
