#pragma once

#include <vector>

#include "engine/check/pair_work.h"

namespace glissade::check {

/// Takes away the thread of one of the bodies, where the file states that, and nothing else but what touches.
/// `stated`: what the file states of the pair, at least one of a core.
void takeCore(const std::vector<StatedAllowance>& stated, PairWork& work);

}  // namespace glissade::check
