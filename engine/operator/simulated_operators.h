#pragma once

#include <memory>
#include <string>

#include "engine/base/result.h"
#include "engine/operator/device_registry.h"

namespace glissade {

/// The name of a run without an operator.
inline constexpr const char* kNoOperator = "none";

/// The operators of runs without a person, for help and errors: "none, expert, default".
std::string simulatedOperatorNames();

/// The operator of this name; null for kNoOperator. Error (Usage): an unknown name.
Result<std::unique_ptr<OperatorDevice>> makeSimulatedOperator(const std::string& name, const DeviceContext& context);

}  // namespace glissade
