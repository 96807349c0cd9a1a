#pragma once

#include "engine/base/json_reader.h"
#include "engine/sequence/order_rules.h"

namespace glissade {

/// The section "sequence" of a scenario file: a person's demands on assembly plans. Private to the readers and writers
/// of this folder. Reading throws JsonError; the bodies are checked when a plan is made.
SequenceDemands readSequence(const JsonCursor& at);
/// Reads and writes the configurations of a step's motion.
std::vector<PathPoint> readMotion(const JsonCursor& at);
JsonCursor::Json motionJson(const std::vector<PathPoint>& path);
/// Adds "sequence" if it is not empty.
void addSequence(const SequenceDemands& demands, JsonCursor::Json& json);

}  // namespace glissade
