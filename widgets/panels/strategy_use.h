#pragma once

#include <set>
#include <string>

#include "engine/base/parameters.h"
#include "engine/planning/planner.h"

namespace glissade {

/// For daily use: it is listed first. The others are listed under "Advanced".
bool isMainStrategy(const std::string& plannerId);

/// The strategy that a run has once somebody holds the object: automatic planners would not ask for the hand.
std::string strategyWithHand(const std::string& plannerId, const std::string& deviceId);

/// The live parameters that have an effect with this strategy while this device holds the object, apart from the pace,
/// which every run has.
std::set<ParameterId> parametersInUse(const PlannerEntry& strategy, const std::string& deviceId);

}  // namespace glissade
