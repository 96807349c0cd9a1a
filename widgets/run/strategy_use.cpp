#include "widgets/run/strategy_use.h"

#include "engine/operator/device_registry.h"
#include "engine/planning/fine/coarse_preview.h"

namespace glissade {
namespace {

/// Whether the strategy samples on the tangent plane of an obstacle; strategies in a loop may select such a planner for
/// a place.
bool samplesContacts(const PlannerEntry& strategy) {
  return strategy.usesOperator && strategy.id != "interactive-birrt";
}

/// Whether the operator feels or sees the guidance: a person, or the simulated haptic hand. The other simulated
/// operators follow their way-points.
bool isGuided(const std::string& deviceId) {
  return deviceId != "expert" && deviceId != "default" && deviceId != "novice" && deviceId != "none";
}

}  // namespace

bool isMainStrategy(const std::string& plannerId) {
  return plannerId == "auto" || plannerId == "by-hand" || plannerId == "gts";
}

bool isPerson(const std::string& deviceId) {
  const DeviceRegistry registry = makeDeviceRegistry();
  const DeviceEntry* entry = registry.find(deviceId);
  return entry != nullptr && !entry->simulated;
}

bool followsHand(const std::string& plannerId) {
  const PlannerRegistry registry = makePlannerRegistry();
  const PlannerEntry* entry = registry.find(plannerId);
  return entry != nullptr && entry->usesOperator;
}

bool isLedByPerson(const std::string& plannerId, const std::string& deviceId) {
  return isPerson(deviceId) && followsHand(plannerId) && !isMultiLayer(plannerId);
}

std::string strategyWithHand(const std::string& plannerId, const std::string& deviceId) {
  return plannerId == "auto" && deviceId != "none" ? "by-hand" : plannerId;
}

std::set<ParameterId> parametersInUse(const PlannerEntry& strategy, const std::string& deviceId) {
  std::set<ParameterId> used{ParameterId::RequiredClearance};
  if (!strategy.usesOperator) return used;
  used.insert(ParameterId::Alpha);
  if (samplesContacts(strategy)) {
    used.insert({ParameterId::ContactSamples, ParameterId::ContactDistance, ParameterId::ContactRadius});
  }
  if (isGuided(deviceId)) {
    used.insert({ParameterId::ContactDistance, ParameterId::GuidanceRepulsion, ParameterId::GuidanceAttraction});
  }
  return used;
}

}  // namespace glissade
