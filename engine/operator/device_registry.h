#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/message.h"
#include "engine/geometry/se3_metric.h"
#include "engine/operator/hand_inputs.h"
#include "engine/operator/operator_input.h"

namespace glissade {

/// Inputs of the devices' factories.
struct DeviceContext {
  std::vector<Pose> route;  ///< a person's plan, with the goal last
  Se3Metric metric{1.0};
  std::uint64_t seed = 1;
  HandInputsPtr hand;       ///< may be null: no person takes part
  CollisionWorldPtr world;  ///< world for the forces of haptic devices; may be null
  bool realTime = false;    ///< time advances by itself, so that a haptic device gets its loop
};

/// The device "hand": all that a person holds together.
inline constexpr const char* kAnyDevice = "hand";

/// Name and factory of a device. Registered by explicit calls.
struct DeviceEntry {
  std::string id;
  Message label;
  Message description;
  bool simulated = false;  ///< needs no person, so that it may run in lockstep
  /// Makes the device; null where the context lacks what the device needs.
  std::function<std::unique_ptr<OperatorDevice>(const DeviceContext&)> make;
  /// Whether the device that a person holds is connected now.
  std::function<bool(HandInputs&)> connected = [](HandInputs&) { return true; };
};

class DeviceRegistry {
 public:
  void add(DeviceEntry entry) { entries_.push_back(std::move(entry)); }
  const DeviceEntry* find(std::string_view id) const;
  const std::vector<DeviceEntry>& entries() const { return entries_; }

 private:
  std::vector<DeviceEntry> entries_;
};

/// The devices hand (all that a person can hold together), keyboard, mouse6d, gamepad, left-controller,
/// right-controller, expert, default, novice, simulated-haptic.
DeviceRegistry makeDeviceRegistry();

/// Adds the simulated persons for studies, which show a way at the level of a task (task_operator.h).
void addTaskOperators(DeviceRegistry& registry);

}  // namespace glissade
