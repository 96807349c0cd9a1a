#pragma once

#include <string>

#include "engine/scenario/path_io.h"

namespace glissade::cli {

/// Writes a path in the format that the file's ending names: .json, OMPL's .path, CSV otherwise.
Outcome writePath(const Path& path, const LoadedScenario& scenario, const PathProvenance& provenance,
                  const std::string& file);

}  // namespace glissade::cli
