#pragma once

#include "engine/base/json_reader.h"
#include "engine/files/scenario.h"

namespace glissade {

/// The part of a scenario file that describes the environment model, the semantic attributes and the rules. Private to
/// the readers and writers of this folder. Reading throws JsonError.
Attributes readAttributes(const std::optional<JsonCursor>& at);
void readSemantics(const JsonCursor& root, Scenario& scenario);
/// Adds "environment", "attributes", "places", "milestones", "rules" if they are not empty.
void addSemantics(const Scenario& scenario, JsonCursor::Json& json);
JsonCursor::Json attributesToJson(const Attributes& attributes);

/// Edits and options alone, for run records. The edits are checked against bodies later.
SemanticEdits readSemanticEdits(const JsonCursor& at);
JsonCursor::Json toJson(const SemanticEdits& edits);
EnvironmentOptions readEnvironmentOptions(const JsonCursor& at);
JsonCursor::Json toJson(const EnvironmentOptions& options);

}  // namespace glissade
