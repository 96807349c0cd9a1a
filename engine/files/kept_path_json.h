#pragma once

#include "engine/base/json_reader.h"
#include "engine/files/kept_path.h"

namespace glissade {

/// The section "paths" of a scenario file. Private to the readers and writers of this folder. Reading throws JsonError.
KeptPaths readKeptPaths(const JsonCursor& at);
/// Adds "paths" if there are any.
void addKeptPaths(const KeptPaths& paths, JsonCursor::Json& json);

}  // namespace glissade
