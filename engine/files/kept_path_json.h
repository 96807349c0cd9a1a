#pragma once

#include "engine/base/json_formats.h"
#include "engine/files/kept_path.h"

namespace glissade {

/// The section "paths" of a scenario file. Reading throws JsonError.
struct KeptPathsFormat {
  KeptPaths read(const JsonCursor& at) const;
  JsonCursor::Json write(const KeptPaths& paths) const;
  JsonCursor::Json schema(SchemaDefinitions& definitions) const;
};

}  // namespace glissade
