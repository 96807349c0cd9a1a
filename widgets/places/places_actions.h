#pragma once

#include <vector>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// The actions of places, attributes and milestones.
std::vector<ActionSpec> placesActions();

}  // namespace glissade
