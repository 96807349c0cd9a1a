#pragma once

#include "engine/base/json_reader.h"
#include "engine/product/fit_settings.h"

namespace glissade {

/// The section "fits" of a scenario file. Private to the readers and writers of this room. Reading throws JsonError;
/// whether the bodies are there is asked when the geometry is loaded.
FitSettings readFits(const JsonCursor& at);
/// Adds "fits" where it says anything.
void addFits(const FitSettings& fits, JsonCursor::Json& json);

}  // namespace glissade
