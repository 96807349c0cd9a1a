#pragma once

#include <string>

#include "engine/evidence/pulled_thread.h"

namespace glissade::evidence {

/// True if names and shapes say that one body of the pair is a nut on the shaft of the other one, whose cylinder is as
/// wide as its hole: a body that is called a nut, or a hexagon with the width, the height and the hole of a nut. Its
/// size and that of the shaft agree where both are known. No shaft that is called a pin has a nut.
bool isNutOnShaft(const CommonThread& cylinders, const LeavingPair& pair);

}  // namespace glissade::evidence
