#include "engine/operator/device_registry.h"

#include <algorithm>

#include "engine/operator/controllers/grasping_hand.h"
#include "engine/operator/haptic/haptic_operator.h"
#include "engine/operator/haptic/simulated_haptic_device.h"
#include "engine/operator/shaped_device.h"
#include "engine/operator/simulated_operator.h"
#include "engine/operator/sliding_hand.h"
#include "engine/operator/task_operator.h"

namespace glissade {
namespace {

/// Several devices in one hand: each moves the object from where the one before has left it. One that holds it at a
/// place of its own comes last, and overrules the others.
class CombinedDevice final : public OperatorDevice {
 public:
  explicit CombinedDevice(std::vector<std::unique_ptr<OperatorDevice>> devices) : devices_(std::move(devices)) {}

  Pose advance(double dt, const OperatorView& view, const Box3& bounds) override {
    OperatorView moved = view;
    for (const auto& device : devices_) moved.q_device = device->advance(dt, moved, bounds);
    return moved.q_device;
  }
  void restart() override {
    for (const auto& device : devices_) device->restart();
  }
  void regrip() override {
    for (const auto& device : devices_) device->regrip();
  }
  void feel(const std::optional<Wrench>& pushedBack) override {
    for (const auto& device : devices_) device->feel(pushedBack);
  }
  bool holds() const override {
    return std::any_of(devices_.begin(), devices_.end(), [](const auto& device) { return device->holds(); });
  }

  bool connected() const override {
    return std::any_of(devices_.begin(), devices_.end(), [](const auto& device) { return device->connected(); });
  }

 private:
  std::vector<std::unique_ptr<OperatorDevice>> devices_;
};

using Member = HandInput HandInputs::*;

/// Adds sliding along the obstacles to a device that a person holds, if there are any.
std::unique_ptr<OperatorDevice> amongObstacles(const DeviceContext& context, std::unique_ptr<OperatorDevice> device) {
  if (!context.world) return device;
  return std::make_unique<SlidingHand>(context.world, std::move(device));
}

std::unique_ptr<OperatorDevice> makeHand(const DeviceContext& context) {
  if (!context.hand) return nullptr;
  std::vector<std::unique_ptr<OperatorDevice>> devices;
  for (const HandInput* input : context.hand->all()) {
    devices.push_back(std::make_unique<ShapedDevice>(context.hand, *input));
  }
  if (context.world) {
    devices.push_back(std::make_unique<GraspingHand>(context.hand, std::nullopt, context.world));
  }
  return amongObstacles(context, std::make_unique<CombinedDevice>(std::move(devices)));
}

DeviceEntry held(Member member, std::string id, CatalogueText label, CatalogueText description) {
  return {std::move(id),
          label,
          description,
          false,
          [member](const DeviceContext& context) -> std::unique_ptr<OperatorDevice> {
            if (!context.hand) return nullptr;
            return amongObstacles(context, std::make_unique<ShapedDevice>(context.hand, (*context.hand).*member));
          },
          [member](HandInputs& hand) { return (hand.*member).mailbox.reading().connected; }};
}

DeviceEntry tracked(ControllerSide side, std::string id, CatalogueText label, CatalogueText description) {
  return {std::move(id),
          label,
          description,
          false,
          [side](const DeviceContext& context) -> std::unique_ptr<OperatorDevice> {
            if (!context.hand || !context.world) return nullptr;
            return amongObstacles(context, std::make_unique<GraspingHand>(context.hand, side, context.world));
          },
          [side](HandInputs& hand) { return hand.controller(side).buttons.mailbox.reading().connected; }};
}

DeviceEntry simulated(const OperatorLevel& level, CatalogueText label, CatalogueText description) {
  return {std::string(level.id), label, description, true,
          [level](const DeviceContext& context) -> std::unique_ptr<OperatorDevice> {
            return std::make_unique<SimulatedOperator>(level, context.route, context.metric, context.seed);
          }};
}

/// Speed of a scripted hand, in radii of the object per second.
constexpr double kHandSpeed = 0.6;

std::unique_ptr<HapticDevice> makeSimulatedHaptic(const DeviceContext& context) {
  const double radius = context.metric.radius();
  return std::make_unique<SimulatedHapticDevice>(alongRoute(context.route, context.metric, kHandSpeed * radius),
                                                 radius);
}

}  // namespace

const DeviceEntry* DeviceRegistry::find(std::string_view id) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const auto& entry) { return entry.id == id; });
  return found == entries_.end() ? nullptr : &*found;
}

DeviceRegistry makeDeviceRegistry() {
  DeviceRegistry registry;
  registry.add({kAnyDevice, GLISSADE_TEXT("My hand"),
                GLISSADE_TEXT("A person: keys, 6D mouse, gamepad and the controllers of a headset together."), false,
                makeHand});
  registry.add(held(&HandInputs::keyboard, "keyboard", GLISSADE_TEXT("Keyboard"),
                    GLISSADE_TEXT("A person: the keys of the window.")));
  registry.add(held(&HandInputs::mouse6d, "mouse6d", GLISSADE_TEXT("6D mouse"),
                    GLISSADE_TEXT("A person: a 3Dconnexion mouse.")));
  registry.add(
      held(&HandInputs::gamepad, "gamepad", GLISSADE_TEXT("Gamepad"), GLISSADE_TEXT("A person: a game controller.")));
  registry.add(tracked(ControllerSide::Left, "left-controller", GLISSADE_TEXT("Left controller"),
                       GLISSADE_TEXT("A person with a headset: its left controller.")));
  registry.add(tracked(ControllerSide::Right, "right-controller", GLISSADE_TEXT("Right controller"),
                       GLISSADE_TEXT("A person with a headset: its right controller.")));
  registry.add(simulated(*findOperatorLevel("expert"), GLISSADE_TEXT("Simulated expert"),
                         GLISSADE_TEXT("Follows the way-points fast and exactly.")));
  registry.add(simulated(*findOperatorLevel("default"), GLISSADE_TEXT("Simulated operator"),
                         GLISSADE_TEXT("Follows the way-points.")));
  registry.add(simulated(*findOperatorLevel("novice"), GLISSADE_TEXT("Simulated novice"),
                         GLISSADE_TEXT("Follows the way-points, slow and unsure.")));
  registry.add(hapticEntry("simulated-haptic", GLISSADE_TEXT("Simulated haptic hand"),
                           GLISSADE_TEXT("Draws the object along the way-points and feels the obstacles."), true,
                           makeSimulatedHaptic));
  return registry;
}

void addTaskOperators(DeviceRegistry& registry) {
  for (const TaskLevel& level : taskLevels()) {
    registry.add({std::string(level.id), Message(std::string(level.id)),
                  GLISSADE_TEXT("Shows a path at the level of a task."), true,
                  [level](const DeviceContext& context) -> std::unique_ptr<OperatorDevice> {
                    return std::make_unique<TaskOperator>(level, context.route, context.metric, context.seed);
                  }});
  }
}

}  // namespace glissade
