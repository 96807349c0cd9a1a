#pragma once

#include "engine/base/json_reader.h"
#include "engine/sequence/order_rules.h"

namespace glissade {

/// The section "sequence" of a scenario file: what a person demands of assembly plans. Private to the readers and
/// writers of this room. Reading throws JsonError; whether the bodies are there is asked when a plan is made.
SequenceDemands readSequence(const JsonCursor& at);
/// The configurations of a step's motion, and back.
std::vector<PathPoint> readMotion(const JsonCursor& at);
JsonCursor::Json motionJson(const std::vector<PathPoint>& path);
/// Adds "sequence" where it says anything.
void addSequence(const SequenceDemands& demands, JsonCursor::Json& json);

}  // namespace glissade
