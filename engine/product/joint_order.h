#pragma once

#include <vector>

#include "engine/product/joint.h"

namespace glissade {

/// Bodies that, by their joints, each leave before the next one, and the last before the first; from this body on,
/// which stands for what it is one body with. Empty: there is no such circle. A screw leaves before what it clamps, a
/// nut before that and its shaft, a flexible body before what it goes around; host and guest, welded bodies and units
/// are one body. Suggested joints do not count.
std::vector<std::size_t> circleThrough(std::size_t body, const Joints& joints, std::size_t bodies);

}  // namespace glissade
