#pragma once

#include "engine/places/rigid_body.h"

namespace glissade {

/// True if `body` of the two is thinned first: the smaller one, by the root mean square distance of its surface from
/// the centre of the surface, which does not depend on the frame; for equal ones the first by id.
bool givesWayFirst(const RigidBody& body, const RigidBody& other);

}  // namespace glissade
