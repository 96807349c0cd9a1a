#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/files/path_exporter.h"
#include "engine/planning/path.h"

namespace glissade {

/// Reads a path file by its content: CSV, JSON, or OMPL's seven columns. Errors name the line. Authors are kept where
/// the format has them. The certificate is not read: use certifyPath. An animation (GLB) is refused by name, because it
/// is for viewing only. `formats`: a file of one that is only written is refused.
Result<std::vector<PathPoint>> readPath(const std::string& file,
                                        const PathExporterRegistry& formats = makePathExporterRegistry());

/// True if the file is a path for readPath: decided by its ending, and for JSON by its "format".
bool isPathFile(const std::string& file);

}  // namespace glissade
