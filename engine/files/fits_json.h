#pragma once

#include "engine/base/json_formats.h"
#include "engine/fits/fit_settings.h"

namespace glissade {

/// The section "fits" of a scenario file. Reading throws JsonError; the bodies are checked when the geometry is loaded.
extern template struct ObjectFormat<FitSettings>;

}  // namespace glissade
