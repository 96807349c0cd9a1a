#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/geometry/se3_metric.h"
#include "engine/operator/hand_inputs.h"
#include "engine/operator/operator_input.h"

namespace glissade {

/// What devices are made from. Each takes what it needs.
struct DeviceContext {
  std::vector<Pose> route;  ///< a person's plan, the goal last
  Se3Metric metric{1.0};
  std::uint64_t seed = 1;
  HandInputsPtr hand;       ///< may be null: nobody is there
  CollisionWorldPtr world;  ///< what a device that pushes back feels; may be null
  bool realTime = false;    ///< time goes on by itself: a haptic device gets its loop
};

/// How a device is known and made. Registered by explicit calls.
struct DeviceEntry {
  std::string id;
  std::string label;
  std::string description;
  bool simulated = false;  ///< needs no person: may run in lockstep
  /// Null where the context lacks what the device needs.
  std::function<std::unique_ptr<OperatorDevice>(const DeviceContext&)> make;
};

class DeviceRegistry {
 public:
  void add(DeviceEntry entry) { entries_.push_back(std::move(entry)); }
  const DeviceEntry* find(std::string_view id) const;
  const std::vector<DeviceEntry>& entries() const { return entries_; }

 private:
  std::vector<DeviceEntry> entries_;
};

/// hand (all that a person can hold together), keyboard, mouse6d, gamepad, left-controller, right-controller, expert,
/// default, novice, simulated-haptic.
DeviceRegistry makeDeviceRegistry();

/// Adds the simulated persons of studies, who show a way at the level of a task (task_operator.h).
void addTaskOperators(DeviceRegistry& registry);

}  // namespace glissade
