#pragma once

#include "widgets/openxr/controller_state.h"
#include "widgets/openxr/room_placement.h"
#include "widgets/openxr/shown_hands.h"

namespace glissade {

/// Passes states of a headset's controllers to the person's devices, and feedback from them to the hands. It knows
/// nothing of OpenXR. The controllers are disconnected before the first state and after the end of the link.
class ControllerLink {
 public:
  /// Squeeze of the trigger above which it is pressed, and below which it is released.
  static constexpr double kTriggerPressed = 0.7;
  static constexpr double kTriggerReleased = 0.4;
  /// A weaker push is not passed on.
  static constexpr double kLeastPush = 0.02;

  explicit ControllerLink(HandInputsPtr hand) : hand_(std::move(hand)) {}
  ~ControllerLink();
  ControllerLink(const ControllerLink&) = delete;
  ControllerLink& operator=(const ControllerLink&) = delete;

  void take(const BothControllers& states, const RoomPlacement& room);
  /// The last state of both controllers, with the feedback to them.
  ShownControllers shown() const;
  ControllerSide mainHand() const { return hand_->mainHand; }
  /// Whether each hand holds the object, by ControllerSide.
  std::array<bool, 2> holds() const;
  /// Strength of the vibration that the hand is to feel now, in [0, 1]; 0: none.
  double push(ControllerSide side) const;

 private:
  using Buttons = std::array<bool, kControllerButtons>;  ///< by ControllerButton

  void connect(ControllerSide side, const std::string& name);
  Buttons pressedOf(ControllerSide side, const ControllerState& state) const;
  void press(ControllerSide side, const Buttons& before);

  HandInputsPtr hand_;
  std::array<std::string, 2> names_;
  std::array<Buttons, 2> pressed_{};
};

}  // namespace glissade
