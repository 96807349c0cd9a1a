#pragma once

#include <vector>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// The actions of the product and its bodies.
std::vector<ActionSpec> productActions();

}  // namespace glissade
