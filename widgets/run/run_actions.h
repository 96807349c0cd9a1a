#pragma once

#include <vector>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// The actions of runs, replays and difficulties.
std::vector<ActionSpec> runActions();

}  // namespace glissade
