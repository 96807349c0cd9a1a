#pragma once

#include <vector>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// The actions of the path and the kept paths.
std::vector<ActionSpec> pathsActions();

}  // namespace glissade
