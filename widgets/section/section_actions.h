#pragma once

#include <vector>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// The actions of sections.
std::vector<ActionSpec> sectionActions();

}  // namespace glissade
