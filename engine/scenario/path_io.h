#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/planning/path.h"
#include "engine/scenario/scenario.h"

namespace glissade {

/// CSV: header "index,s,x,y,z,qx,qy,qz,qw,clearance,contact,author"; s is the metric length from the
/// start; numbers round-trip exactly. `clearance` is the distance to the nearest obstacle at the
/// configuration ("inf" where there is none); `contact` is 1 where that is less than the contact
/// distance d, else 0. Saved atomically.
Outcome writePathCsv(const Path& path, const LoadedScenario& scenario, const std::string& file);
/// OMPL's seven columns "x y z qx qy qz qw".
Outcome writePathOmpl(const Path& path, const std::string& file);
/// JSON with provenance (scenario, seed, planner, version, certificate).
struct PathProvenance {
  std::string planner;
  std::uint64_t seed = 0;
};
Outcome writePathJson(const Path& path, const LoadedScenario& scenario, const PathProvenance& provenance,
                      const std::string& file);

/// Reads any of the three, told apart by their content. Errors are MalformedInput and name the line or
/// JSON pointer. Authors are kept where the format has them. The certificate is not read: use
/// certifyPath. Orientations are as in the file: unit within tolerance::kQuaternionNorm.
Result<std::vector<PathPoint>> readPath(const std::string& file);

}  // namespace glissade
