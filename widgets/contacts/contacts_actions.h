#pragma once

#include <vector>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// The actions of fits and joints.
std::vector<ActionSpec> contactsActions();

}  // namespace glissade
