#pragma once

#include <set>
#include <string>

#include "engine/base/parameters.h"
#include "engine/planning/planner.h"

namespace glissade {

/// Whether the strategy is for daily use: it is listed at first sight. The others are listed under
/// "Research".
bool isMainStrategy(const std::string& plannerId);

/// Whether a person holds the device, and whether the strategy asks an operator.
bool isPerson(const std::string& deviceId);
bool followsHand(const std::string& plannerId);

/// Whether a person's hand leads the search, which then takes the person's time. Layers ask for a hand in few places
/// only.
bool isLedByPerson(const std::string& plannerId, const std::string& deviceId);

/// The strategy of a run while a device is held: automatic planners would not ask for the hand.
std::string strategyWithHand(const std::string& plannerId, const std::string& deviceId);

/// The live parameters that affect this strategy with this device, apart from the pace, which every run has.
std::set<ParameterId> parametersInUse(const PlannerEntry& strategy, const std::string& deviceId);

}  // namespace glissade
