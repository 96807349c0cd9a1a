#pragma once

#include <vector>

#include "engine/base/diagnostic.h"
#include "engine/places/rigid_body.h"

namespace glissade {

/// Replaces ids of bodies in warnings, and the paths that importers know, by the displayed names.
void nameByLabels(Warnings& warnings, const std::vector<RigidBody>& bodies);

}  // namespace glissade
