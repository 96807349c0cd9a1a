#pragma once

#include "widgets/headset/controller_state.h"
#include "widgets/headset/pointer_mailbox.h"

namespace glissade {

/// What the panel follows.
struct PanelInput {
  Pose X_RH;  ///< of the head, in the room
  ControllerSide mainHand = ControllerSide::Right;
  std::array<bool, 2> holds{};  ///< the object; by ControllerSide
  bool isInFront = false;       ///< it stays before the person
};

/// A hand that points at the panel.
struct PanelTouch {
  ControllerSide side = ControllerSide::Right;
  double distance = 0.0;  ///< along its aim, metres of the room
  PanelPointer pointer;
};

/// Where the panel P is in the room R, and which hand points at it. P: x right, y up, z to the person, the origin in
/// the middle; metres of the room, whatever the scale of the world is.
///
/// It stands over the other hand, or stays where it came to be before the person. A hand that points at it does nothing
/// else: its squeeze and its trigger are the panel's. A trigger that was pressed before is not a press of the panel. A
/// press that began at the panel stays with it until the trigger is released, so that a slider can be dragged past its
/// end.
class PanelInRoom {
 public:
  static constexpr double kWidth = 0.40;
  static constexpr double kHeight = 0.32;
  /// Of the panel from the head, where it stays before the person.
  static constexpr double kDistance = 0.6;

  /// Another moment. What the panel takes of the hands is taken out of `states`.
  void advance(BothControllers& states, const PanelInput& input);
  /// Nothing: the other hand is not tracked.
  const std::optional<Pose>& X_RP() const { return X_RP_; }
  const std::optional<PanelTouch>& touch() const { return touch_; }

 private:
  void place(const BothControllers& states, const PanelInput& input);
  std::optional<PanelTouch> touchOf(const ControllerState& state, ControllerSide side) const;

  std::optional<Pose> X_RP_;
  bool isInFront_ = false;
  std::optional<PanelTouch> touch_;
  bool wasReleased_ = false;  ///< the trigger, since the hand points at the panel
};

}  // namespace glissade
