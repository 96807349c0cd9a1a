#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/planning/path.h"

namespace glissade {

/// Reads a path file by its content: CSV, JSON, or OMPL's seven columns. Errors name the line. Authors
/// are kept where the format has them. The certificate is not read: use certifyPath. An animation (GLB)
/// is refused by name: it is there to be looked at.
Result<std::vector<PathPoint>> readPath(const std::string& file);

/// Whether a file is meant to be a path that readPath takes: by its ending, of JSON by what it says that it is.
bool isPathFile(const std::string& file);

}  // namespace glissade
