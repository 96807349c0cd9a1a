#pragma once

#include <vector>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// The actions of help and the log.
std::vector<ActionSpec> helpActions();

}  // namespace glissade
