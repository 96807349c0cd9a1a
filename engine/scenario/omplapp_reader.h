#pragma once

#include <string>

#include "engine/scenario/scenario.h"

namespace glissade {

/// Parses an OMPL.app rigid-body problem (.cfg, an INI file) into a scenario that means the same to
/// us as to OMPL.app: meshes as assimp gives them, the robot centred on the mean of its vertices,
/// orientations from axis and angle, the volume grown to contain start and goal. Only [problem] is
/// read; OMPL's own settings (sampler, benchmark, planner) say nothing about the problem. Errors are
/// MalformedInput with the line or key as place.
Result<Scenario> parseOmplApp(const std::string& text, const std::string& file);

}  // namespace glissade
