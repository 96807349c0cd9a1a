#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/check/path.h"
#include "engine/check/plan.h"

namespace glissade::check {

/// Reads a path: Glissade's CSV or JSON, or OMPL's seven columns. Errors: MalformedInput with the line or the place.
Result<Path> readPath(const std::string& file);

/// Reads an assembly plan without trusting its statements. Errors: MalformedInput if it is none.
Result<Plan> readPlan(const std::string& file);

/// True if the file says that it is an assembly plan.
bool isPlan(const std::string& file);

}  // namespace glissade::check
