#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "engine/operator/controllers/controller_mailbox.h"
#include "engine/operator/input_mailbox.h"
#include "engine/operator/shaping_presets.h"

namespace glissade {

/// The shaping in force, written by the calibration page and read by the operator thread. The latest one counts.
class ShapingMailbox {
 public:
  explicit ShapingMailbox(const DeviceShaping& shaping) : shaping_(shaping) {}

  void set(const DeviceShaping& shaping) {
    const std::lock_guard lock(mutex_);
    shaping_ = inRange(shaping);
  }
  DeviceShaping get() const {
    const std::lock_guard lock(mutex_);
    return shaping_;
  }

 private:
  mutable std::mutex mutex_;
  DeviceShaping shaping_;
};

/// One device in a person's hand.
struct HandInput {
  HandInput(InputKind which, std::optional<std::chrono::milliseconds> silence)
      : kind(which), mailbox(silence), shaping(standardShaping(which)) {}

  const InputKind kind;
  InputMailbox mailbox;
  ShapingMailbox shaping;
};

/// A tracked controller of a headset, in one hand.
struct ControllerInput {
  ControllerInput(InputKind which, std::optional<std::chrono::milliseconds> silence)
      : buttons(which, std::nullopt), place(silence) {}

  HandInput buttons;  ///< numbered by ControllerButton; no axes
  ControllerMailbox place;
};

enum class ControllerSide { Left, Right };

/// Indices of a controller's buttons in its mailbox.
enum class ControllerButton : std::size_t {
  Trigger,
  Menu,   ///< menu button, or the upper button where the runtime uses the menu button
  Lower,  ///< lower of the two buttons beside the stick
  Upper,
  Stick
};
inline constexpr std::size_t kControllerButtons = 5;

/// Target of the hand's deflections.
enum class SteeringTarget { Object, Camera };

/// All devices that a person can hold. They stay open as long as the program runs, while runs and scenarios change.
/// Shared by their readers, the operator thread and the window.
struct HandInputs {
  /// Silence after which a 6D mouse is at rest. It repeats its deflection while it is held.
  static constexpr std::chrono::milliseconds kSilence{500};
  /// Silence after which a controller is lost. A headset reports the hands with each picture, and pictures are slow
  /// where drawing is slow.
  static constexpr std::chrono::milliseconds kControllerSilence{1000};

  /// `silence` nothing: for a script that moves the mouse in its own time.
  explicit HandInputs(std::optional<std::chrono::milliseconds> silence = kSilence)
      : mouse6d(InputKind::Mouse6D, silence),
        leftController(InputKind::LeftController, silence ? std::optional(kControllerSilence) : std::nullopt),
        rightController(InputKind::RightController, silence ? std::optional(kControllerSilence) : std::nullopt) {
    keyboard.mailbox.connect("Keyboard");
  }

  HandInput keyboard{InputKind::Keyboard, std::nullopt};
  HandInput mouse6d;
  HandInput gamepad{InputKind::Gamepad, std::nullopt};
  ControllerInput leftController;
  ControllerInput rightController;
  /// The hand that takes the object.
  std::atomic<ControllerSide> mainHand{ControllerSide::Right};
  /// False: the controllers of a headset take something else than the object, and report themselves what they hold.
  std::atomic<bool> controllersMoveObject{true};
  std::atomic<SteeringTarget> target{SteeringTarget::Object};
  std::atomic<bool> focused{true};  ///< false: another program has the window focus, so that all devices are at rest

  ControllerInput& controller(ControllerSide side) {
    return side == ControllerSide::Left ? leftController : rightController;
  }
  std::array<ControllerInput*, 2> controllers() { return {&leftController, &rightController}; }
  /// Devices with axes.
  std::array<HandInput*, 3> all() { return {&keyboard, &mouse6d, &gamepad}; }
  /// Devices whose buttons may have an action; those with axes come first.
  std::array<HandInput*, 5> withButtons() {
    return {&keyboard, &mouse6d, &gamepad, &leftController.buttons, &rightController.buttons};
  }
};
using HandInputsPtr = std::shared_ptr<HandInputs>;

}  // namespace glissade
