#pragma once

#include "engine/planning/planner.h"

namespace glissade {

/// Adds the peers: planners of unmodified OMPL, which benchmarks compare with ours (OmplManner::AsItIs).
void registerPeerPlanners(PlannerRegistry& registry);

/// The planners of makePlannerRegistry() and the peers, for studies and for glissade-cli, which runs them.
PlannerRegistry makePlannerRegistryWithPeers();

}  // namespace glissade
