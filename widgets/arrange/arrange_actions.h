#pragma once

#include <vector>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// The actions of the placement of bodies.
std::vector<ActionSpec> arrangeActions();

}  // namespace glissade
