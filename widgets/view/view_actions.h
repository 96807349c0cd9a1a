#pragma once

#include <vector>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// The actions of the view of the scene.
std::vector<ActionSpec> viewActions();

}  // namespace glissade
