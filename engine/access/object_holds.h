#pragma once

#include <vector>

#include "engine/access/hand_hold.h"

namespace glissade {

/// Ways to pinch a body between thumb and fingers, the most natural ones first: at points of its surface where another
/// surface of it faces away, from eight sides each. `object_W` is the body where its motion begins; `leaving`: the
/// direction in which it leaves, or zero: the forearm is preferred there, and above. Whether a hand goes through the
/// body, or others, is not asked. None where no place of the body fits between the fingers.
std::vector<HandHold> objectHolds(const TriangleMesh& object_W, const Vector3& leaving, HandShapes& shapes);

/// Ways to push a body with a stretched finger against the direction in which it leaves, from the middle outwards. None
/// where it does not leave straight, or no surface of it looks there.
std::vector<HandHold> pushHolds(const TriangleMesh& object_W, const Vector3& leaving, HandShapes& shapes);

}  // namespace glissade
