#pragma once

#include <string>
#include <vector>

#include "engine/planning/path.h"
#include "engine/scenario/scenario.h"

namespace glissade {

/// CSV: header "index,s,x,y,z,qx,qy,qz,qw,clearance,contact,author"; s is the metric length from the
/// start; numbers round-trip exactly. `clearance` is the distance to the nearest obstacle at the
/// configuration. Saved atomically.
Outcome writePathCsv(const Path& path, const LoadedScenario& scenario, const std::string& file);
/// OMPL's seven columns "x y z qx qy qz qw".
Outcome writePathOmpl(const Path& path, const std::string& file);
/// JSON with provenance (scenario, seed, planner, version, certificate).
Outcome writePathJson(const Path& path, const LoadedScenario& scenario, const PathProvenance& provenance,
                      const std::string& file);

/// Reads any of the three by content and ending. Errors name the line. Authors are kept where the
/// format has them. The certificate is not read: use certifyPath.
Result<std::vector<PathPoint>> readPath(const std::string& file);

/// Whether a file is meant to be a path: by its ending, of JSON by what it says that it is.
bool isPathFile(const std::string& file);

}  // namespace glissade
