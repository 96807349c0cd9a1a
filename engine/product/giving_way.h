#pragma once

#include "engine/environment/rigid_body.h"

namespace glissade {

/// Whether the body of the two is taken thinner first: the smaller one, by the root mean square distance of its surface
/// from the centre of the surface, which is the same in every frame; of equal ones, the first by id.
bool givesWayFirst(const RigidBody& body, const RigidBody& other);

}  // namespace glissade
