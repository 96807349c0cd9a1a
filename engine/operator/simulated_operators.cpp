#include "engine/operator/simulated_operators.h"

namespace glissade {
namespace {

DeviceRegistry devicesWithTaskOperators() {
  DeviceRegistry registry = makeDeviceRegistry();
  addTaskOperators(registry);
  return registry;
}

}  // namespace

std::string simulatedOperatorNames() {
  std::string names = kNoOperator;
  const DeviceRegistry registry = devicesWithTaskOperators();
  for (const DeviceEntry& entry : registry.entries()) {
    if (entry.simulated) names += ", " + entry.id;
  }
  return names;
}

Result<std::unique_ptr<OperatorDevice>> makeSimulatedOperator(const std::string& name, const DeviceContext& context) {
  if (name == kNoOperator) return std::unique_ptr<OperatorDevice>();
  const DeviceRegistry registry = devicesWithTaskOperators();
  const DeviceEntry* entry = registry.find(name);
  if (entry == nullptr || !entry->simulated) {
    return Diagnostic{ErrorKind::Usage,
                      "",
                      "operator",
                      {GLISSADE_TEXT("there is no operator '%1'"), {name}},
                      {GLISSADE_TEXT("Choose one of: %1."), {simulatedOperatorNames()}}};
  }
  return entry->make(context);
}

}  // namespace glissade
