#pragma once

#include <vector>

#include "engine/base/json_formats.h"
#include "engine/fits/assembled_product.h"
#include "engine/fits/joint.h"

namespace glissade {

/// The section "joints" of a scenario file: a person's statements about joints. Reading throws JsonError; bodies and
/// joints are checked when joints are found.
struct JointEditsFormat {
  std::vector<JointEdit> read(const JsonCursor& at) const;
  JsonCursor::Json write(const std::vector<JointEdit>& edits) const;
  JsonCursor::Json schema(SchemaDefinitions& definitions) const;
};

/// A joint for reports, with the ids of its bodies: resources/schema/joints-1.schema.json.
JsonCursor::Json toJson(const Joint& joint, const AssembledProduct& product);

}  // namespace glissade
