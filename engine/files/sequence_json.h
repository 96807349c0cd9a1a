#pragma once

#include "engine/base/json_formats.h"
#include "engine/sequence/order_rules.h"

namespace glissade {

/// The section "sequence" of a scenario file: a person's demands on assembly plans. Reading throws JsonError; the
/// bodies are checked when a plan is made.
extern template struct ObjectFormat<SequenceDemands>;

/// The configurations of a step's motion, at least `least`.
struct MotionFormat {
  std::size_t least = 1;

  std::vector<PathPoint> read(const JsonCursor& at) const;
  JsonCursor::Json write(const std::vector<PathPoint>& path) const;
  JsonCursor::Json schema(SchemaDefinitions& definitions) const;
};

}  // namespace glissade
