#pragma once

#include <vector>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// The actions of sequences, instructions and the access of a hand.
std::vector<ActionSpec> sequenceActions();

}  // namespace glissade
