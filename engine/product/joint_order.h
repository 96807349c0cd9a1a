#pragma once

#include <vector>

#include "engine/product/joint.h"

namespace glissade {

/// A circle of bodies, beginning with this body, each of which has to leave before the next one, and the last before
/// the first. Empty if there is none. A screw leaves before the parts that it clamps, a nut before those and its shaft,
/// a flexible body before the bodies that it goes around; host and guest, welded bodies and units are one body.
/// Suggested joints do not count.
std::vector<std::size_t> circleThrough(std::size_t body, const Joints& joints, std::size_t bodies);

}  // namespace glissade
