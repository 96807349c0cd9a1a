#pragma once

#include <vector>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// The actions of the window itself.
std::vector<ActionSpec> shellActions();

}  // namespace glissade
