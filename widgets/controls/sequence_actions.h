#pragma once

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// The actions of sequences and of their documents, a part of actionSpecs().
const std::vector<ActionSpec>& sequenceActionSpecs();

}  // namespace glissade
