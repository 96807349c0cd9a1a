#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/files/path_exporter.h"

// Makes the contents of text path files. The conditions of PathExporter::content apply to all functions.
namespace glissade {

/// Header "index,s,x,y,z,qx,qy,qz,qw,clearance,contact,author"; s is the metric length from the start,
/// `clearance` the distance to the nearest obstacle at the configuration. Numbers round-trip exactly.
Result<std::string> pathAsCsv(const Path& path, const LoadedScenario& scenario, const PathProvenance& provenance);

/// OMPL's seven columns "x y z qx qy qz qw".
Result<std::string> pathAsOmpl(const Path& path, const LoadedScenario& scenario, const PathProvenance& provenance);

/// JSON with provenance, and the certificate of every edge.
Result<std::string> pathAsJson(const Path& path, const LoadedScenario& scenario, const PathProvenance& provenance);

/// Scenario, planner, seed, program and certificate, for any format that can hold them.
nlohmann::ordered_json provenanceJson(const Path& path, const LoadedScenario& scenario,
                                      const PathProvenance& provenance);

}  // namespace glissade
