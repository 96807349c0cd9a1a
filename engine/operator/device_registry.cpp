#include "engine/operator/device_registry.h"

#include <algorithm>

#include "engine/operator/combined_device.h"
#include "engine/operator/simulated_operator.h"
#include "engine/operator/spacenav_device.h"

namespace glissade {
namespace {

std::unique_ptr<OperatorDevice> makeHand(const DeviceContext& context) {
  std::vector<std::unique_ptr<OperatorDevice>> devices;
  if (context.keys) devices.push_back(std::make_unique<KeyboardDevice>(context.keys));
  devices.push_back(std::make_unique<SpacenavDevice>());
  return std::make_unique<CombinedDevice>(std::move(devices));
}

std::unique_ptr<OperatorDevice> makeKeyboard(const DeviceContext& context) {
  if (!context.keys) return nullptr;
  return std::make_unique<KeyboardDevice>(context.keys);
}

DeviceEntry simulated(const OperatorLevel& level, std::string label, std::string description) {
  return {std::string(level.id), std::move(label), std::move(description), true,
          [level](const DeviceContext& context) -> std::unique_ptr<OperatorDevice> {
            return std::make_unique<SimulatedOperator>(level, context.route, context.metric, context.seed);
          }};
}

}  // namespace

const DeviceEntry* DeviceRegistry::find(std::string_view id) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const auto& entry) { return entry.id == id; });
  return found == entries_.end() ? nullptr : &*found;
}

DeviceRegistry makeDeviceRegistry() {
  DeviceRegistry registry;
  registry.add(
      {"hand", "Keyboard and 6D mouse", "A person: the keys of the window and a 3Dconnexion mouse.", false, makeHand});
  registry.add({"keyboard", "Keyboard", "A person: the keys of the window.", false, makeKeyboard});
  registry.add(simulated(*findOperatorLevel("expert"), "Simulated expert", "Follows the way-points fast and exactly."));
  registry.add(simulated(*findOperatorLevel("default"), "Simulated operator", "Follows the way-points."));
  registry.add(simulated(*findOperatorLevel("novice"), "Simulated novice", "Follows the way-points, slow and unsure."));
  return registry;
}

}  // namespace glissade
