#pragma once

#include <vector>

#include "engine/check/pair_work.h"

namespace glissade::check {

/// Takes away the thread of one body if the file states that; other faces get an allowance for their contacts only.
/// `stated`: the statements of the file about the pair, at least one with a core.
void takeCore(const std::vector<StatedAllowance>& stated, PairWork& work);

}  // namespace glissade::check
