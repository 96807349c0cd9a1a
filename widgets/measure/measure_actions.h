#pragma once

#include <vector>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// The actions of measurements.
std::vector<ActionSpec> measureActions();

}  // namespace glissade
