#pragma once

#include <vector>

#include "engine/base/json_reader.h"
#include "engine/product/assembled_product.h"
#include "engine/product/joint.h"

namespace glissade {

/// The section "joints" of a scenario file: what a person says of joints. Reading throws JsonError; whether bodies and
/// joints are there is asked where joints are found.
std::vector<JointEdit> readJointEdits(const JsonCursor& at);
/// Adds "joints" where it says anything.
void addJointEdits(const std::vector<JointEdit>& edits, JsonCursor::Json& json);

/// A joint as reports have it, with the ids of its bodies: resources/schema/joints-1.schema.json.
JsonCursor::Json toJson(const Joint& joint, const AssembledProduct& product);

}  // namespace glissade
