#pragma once

#include <set>
#include <string>

#include "engine/base/parameters.h"
#include "engine/planning/planner.h"

namespace glissade {

/// Whether the strategy is for daily use: it is listed at first sight. The others are listed under
/// "Research".
bool isMainStrategy(const std::string& plannerId);

/// The strategy of a run while a device is held: automatic planners would not ask for the hand.
std::string strategyWithHand(const std::string& plannerId, const std::string& deviceId);

/// The live parameters that affect this strategy with this device, apart from the pace, which every run has.
std::set<ParameterId> parametersInUse(const PlannerEntry& strategy, const std::string& deviceId);

}  // namespace glissade
