#pragma once

#include "engine/base/json_formats.h"
#include "engine/files/scenario.h"

namespace glissade {

// The part of a scenario file that describes the environment model, the semantic attributes and the rules. Private to
// the readers and writers of this folder. Reading throws JsonError.

/// Semantic attributes by name.
struct AttributesFormat {
  Attributes read(const JsonCursor& at) const;
  JsonCursor::Json write(const Attributes& attributes) const;
  JsonCursor::Json schema(SchemaDefinitions& definitions) const;
};

extern template struct ObjectFormat<EnvironmentOptions>;
extern template struct ObjectFormat<AttributeDefinition>;
extern template struct ObjectFormat<PlaceEdit>;
extern template struct ObjectFormat<MilestoneEdit>;
extern template struct ObjectFormat<ForbiddenPlace>;
extern template struct ObjectFormat<StrategyRules>;
/// Edits alone, for run records. They are checked against bodies later.
extern template struct ObjectFormat<SemanticEdits>;

/// Refuses wrong attributes, nodes and rules when the file is read, so that the message can state the place. `root`:
/// the document of the scenario. Throws JsonError.
void checkSemantics(const Scenario& scenario, const JsonCursor& root);

}  // namespace glissade
