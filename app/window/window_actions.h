#pragma once

#include <vector>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// The actions of all features, in the order of the help page.
std::vector<ActionSpec> windowActions();

}  // namespace glissade
