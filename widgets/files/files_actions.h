#pragma once

#include <vector>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// The actions of the files of scenarios.
std::vector<ActionSpec> filesActions();

}  // namespace glissade
