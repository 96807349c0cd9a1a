#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/scenario/scenario.h"

namespace glissade {

/// Refuses a scenario that has expanded to more than limits::kMostBodies rigid bodies.
Outcome checkNumberOfBodies(const LoadedScenario& loaded, const std::string& file);

/// Refuses a scenario whose bodies or object, as they are placed, reach beyond limits::kLargestLength, whose object is
/// smaller than limits::kSmallestSize, or whose workspace is more than limits::kLargestRatio times the object's radius.
/// Errors are MalformedInput with the body as location.
Outcome checkExtents(const LoadedScenario& loaded, const Box3& workspace, const std::string& file);

}  // namespace glissade
