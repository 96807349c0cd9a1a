#pragma once

#include <glissade/problem.h>

#include <optional>

#include "engine/base/parameters.h"

namespace glissade::api {

/// Sets the parameters. Returns the fault of the first one that is unknown or out of its range.
std::optional<Diagnostic> setAll(const Parameters& parameters, ParameterValues& values);

/// All parameters with their values.
Parameters publicParameters(const ParameterValues& values);

}  // namespace glissade::api
