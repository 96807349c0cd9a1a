#pragma once

#include <vector>

#include "engine/check/pair_work.h"

namespace glissade::check {

/// Removes from a body the volume that the other body of the pair fills, if the file states that and a person accepts
/// the clash. The other body is thinned all around. `stated`: the statements of the file about the pair, at least one
/// about a hollow body.
void takeHollow(const std::vector<StatedAllowance>& stated, PairWork& work);

}  // namespace glissade::check
