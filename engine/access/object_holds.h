#pragma once

#include <vector>

#include "engine/access/hand_hold.h"

namespace glissade {

/// Ways to pinch a body between thumb and fingers, the most natural ones first: at points of its surface with an
/// opposite surface facing away, from eight sides each. `object_W`: the body at the beginning of its motion; `leaving`:
/// its exit direction, or zero; the forearm is preferred on that side, and above (`up`, unit). Collisions of the hand
/// are not tested. Empty if no place of the body fits between the fingers.
std::vector<HandHold> objectHolds(const TriangleMesh& object_W, const Vector3& leaving, const Vector3& up,
                                  HandShapes& shapes);

/// Ways to push a body with a stretched finger against its exit direction, from the middle outwards. Empty if it does
/// not leave straight, or if no surface of it faces that direction.
std::vector<HandHold> pushHolds(const TriangleMesh& object_W, const Vector3& leaving, HandShapes& shapes);

}  // namespace glissade
