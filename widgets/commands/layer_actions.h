#pragma once

#include "widgets/commands/action_catalogue.h"

namespace glissade {

/// The actions that show and hide what the scene draws, a part of actionSpecs().
const std::vector<ActionSpec>& layerActionSpecs();

}  // namespace glissade
