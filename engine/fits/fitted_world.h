#pragma once

#include <vector>

#include "engine/collision/collision_query.h"
#include "engine/fits/fit.h"

namespace glissade {

/// The world with the thinned bodies of the fits, in which threads come apart by turning only. The object is thinned
/// against the obstacle of its fit only. `object`: the world's. Precondition: `world` has no fits.
CollisionWorldPtr withFits(const CollisionWorldPtr& world, const MeshPtr& object, const std::vector<Fit>& fits);

/// The rules of the fits that are threads, one for each obstacle.
std::vector<ThreadRule> threadRulesOf(const std::vector<Fit>& fits);

}  // namespace glissade
