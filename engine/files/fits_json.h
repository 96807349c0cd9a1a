#pragma once

#include "engine/base/json_reader.h"
#include "engine/fits/fit_settings.h"

namespace glissade {

/// The section "fits" of a scenario file. Private to the readers and writers of this folder. Reading throws JsonError;
/// the bodies are checked when the geometry is loaded.
FitSettings readFits(const JsonCursor& at);
/// Adds "fits" if it is not empty.
void addFits(const FitSettings& fits, JsonCursor::Json& json);

}  // namespace glissade
