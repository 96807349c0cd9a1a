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

/// The shaping in force: written by the calibration page, read by the operator thread; latest wins.
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

  HandInput buttons;  ///< numbered as ControllerButton says; no axes
  ControllerMailbox place;
};

enum class ControllerSide { Left, Right };

/// Buttons of a controller, in the numbers of its mailbox.
enum class ControllerButton : std::size_t {
  Trigger,
  Menu,   ///< or the upper button, where the menu is the runtime's
  Lower,  ///< of two buttons beside the stick
  Upper,
  Stick
};
inline constexpr std::size_t kControllerButtons = 5;

/// What the hand's deflections move.
enum class SteeringTarget { Object, Camera };

/// All that a person can hold, for as long as the program runs: runs and scenarios come and go while the
/// devices stay open. Shared by their readers, the operator thread and the window.
struct HandInputs {
  /// A 6D mouse repeats its deflection while it is held: half a second of silence is rest.
  static constexpr std::chrono::milliseconds kSilence{500};
  /// A headset says with each picture where the hands are, and pictures are slow where drawing is.
  static constexpr std::chrono::milliseconds kControllerSilence{1000};

  /// No silence: a script holds the mouse, in a time of its own.
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
  /// The hand that takes the object; the other one is free for other things.
  std::atomic<ControllerSide> mainHand{ControllerSide::Right};
  /// False: controllers of a headset do something else with what they take, and say themselves what they hold.
  std::atomic<bool> controllersMoveObject{true};
  std::atomic<SteeringTarget> target{SteeringTarget::Object};
  std::atomic<bool> focused{true};  ///< false: another program has the window focus, all is at rest

  ControllerInput& controller(ControllerSide side) {
    return side == ControllerSide::Left ? leftController : rightController;
  }
  std::array<ControllerInput*, 2> controllers() { return {&leftController, &rightController}; }
  /// Devices with axes.
  std::array<HandInput*, 3> all() { return {&keyboard, &mouse6d, &gamepad}; }
  /// Devices whose buttons may have an action, those with axes first.
  std::array<HandInput*, 5> withButtons() {
    return {&keyboard, &mouse6d, &gamepad, &leftController.buttons, &rightController.buttons};
  }
};
using HandInputsPtr = std::shared_ptr<HandInputs>;

}  // namespace glissade
