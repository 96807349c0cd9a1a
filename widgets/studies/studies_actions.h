#pragma once

#include <vector>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// The actions of studies.
std::vector<ActionSpec> studiesActions();

}  // namespace glissade
