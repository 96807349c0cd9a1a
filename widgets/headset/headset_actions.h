#pragma once

#include <vector>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// The actions of the headset.
std::vector<ActionSpec> headsetActions();

}  // namespace glissade
