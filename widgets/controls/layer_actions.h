#pragma once

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// The actions that show and hide layers of the scene, a part of actionSpecs().
const std::vector<ActionSpec>& layerActionSpecs();

}  // namespace glissade
