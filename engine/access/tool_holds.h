#pragma once

#include <vector>

#include "engine/access/hand_hold.h"
#include "engine/sequence/tool_shape.h"

namespace glissade {

/// Ways to hold a tool on a fastener's head: a screwdriver by its handle with the forearm behind it, another tool in a
/// fist at the end of its arm, where that is longer than a hand is broad, or between thumb and fingers; with the
/// handle in all positions. `X_WT`: the tool's frame with its handle in the first position.
std::vector<HandHold> toolHolds(ToolKind kind, const FastenerHead& head, const Pose& X_WT, HandShapes& shapes);

}  // namespace glissade
