#pragma once

#include <glissade/operators.h>

#include <memory>

#include "engine/operator/operator_input.h"

namespace glissade::api {

/// The device of an operator from outside.
std::unique_ptr<OperatorDevice> deviceOf(OperatorFunction hand);

}  // namespace glissade::api
