#pragma once

#include "engine/collision/kernel/lanes.h"

namespace glissade::lanes {

/// The implementations, one in each file. That of an instruction set may only be called where the machine has it.
const LaneFunctions& portable();
const LaneFunctions& sse2();
const LaneFunctions& avx2();

}  // namespace glissade::lanes
