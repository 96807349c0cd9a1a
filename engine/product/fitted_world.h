#pragma once

#include <vector>

#include "engine/collision/collision_query.h"
#include "engine/product/fit.h"

namespace glissade {

/// The world in which each fit's body is taken thinner, the object against its own obstacle only, and threads come
/// apart by turning only. `object`: the world's. Precondition: `world` has no fits.
CollisionWorldPtr withFits(const CollisionWorldPtr& world, const MeshPtr& object, const std::vector<Fit>& fits);

/// The rules of the fits that are threads, one for each obstacle.
std::vector<ThreadRule> threadRulesOf(const std::vector<Fit>& fits);

}  // namespace glissade
