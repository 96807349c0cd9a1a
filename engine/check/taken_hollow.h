#pragma once

#include <vector>

#include "engine/check/pair_work.h"

namespace glissade::check {

/// Takes away of a body what the other one of the pair fills of it, where the file states that and a person accepts the
/// clash. The one that fills it is taken thinner all around. `stated`: what the file states of the pair, at least one
/// of a hollow body.
void takeHollow(const std::vector<StatedAllowance>& stated, PairWork& work);

}  // namespace glissade::check
