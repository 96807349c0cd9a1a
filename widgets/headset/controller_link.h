#pragma once

#include "widgets/headset/controller_state.h"
#include "widgets/headset/room_placement.h"
#include "widgets/headset/shown_hands.h"

namespace glissade {

/// Brings what the controllers of a headset say to the devices of the person, and says what their hands are to feel.
/// Knows nothing of OpenXR. The controllers are away before the first state and after the end of the link.
class ControllerLink {
 public:
  /// Squeeze of the trigger from which on it is pressed, and below which it is released.
  static constexpr double kTriggerPressed = 0.7;
  static constexpr double kTriggerReleased = 0.4;
  /// A weaker push is not felt.
  static constexpr double kLeastPush = 0.02;

  explicit ControllerLink(HandInputsPtr hand) : hand_(std::move(hand)) {}
  ~ControllerLink();
  ControllerLink(const ControllerLink&) = delete;
  ControllerLink& operator=(const ControllerLink&) = delete;

  void take(const BothControllers& states, const RoomPlacement& room);
  /// Both controllers as they were said last, and what came of it.
  ShownControllers shown() const;
  ControllerSide mainHand() const { return hand_->mainHand; }
  /// By ControllerSide: which hand holds the object.
  std::array<bool, 2> holds() const;
  /// What the hand is to feel now, in [0, 1]; 0: nothing.
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
