#pragma once

#include <vector>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// The actions of devices of the operator.
std::vector<ActionSpec> devicesActions();

}  // namespace glissade
