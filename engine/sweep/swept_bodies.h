#pragma once

#include <vector>

#include "engine/places/rigid_body.h"
#include "engine/sweep/swept_volume.h"

namespace glissade {

/// The bodies, by index, ascending, that touch the surface of the swept volume or are inside of it. A body that the
/// moving body passes at a distance below the bound may be among them. Unfinished after a stop.
std::vector<std::size_t> bodiesWithin(const SweptVolume& sweep, const std::vector<RigidBody>& bodies,
                                      const StopToken& stop = {});

}  // namespace glissade
