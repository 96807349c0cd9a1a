#pragma once

#include "widgets/openxr/controller_state.h"
#include "widgets/openxr/pointer_mailbox.h"

namespace glissade {

/// The poses and the state that the panel follows.
struct PanelInput {
  Pose X_RH;  ///< pose of the head, in the room
  ControllerSide mainHand = ControllerSide::Right;
  std::array<bool, 2> holds{};  ///< whether each hand holds the object, by ControllerSide
  bool isInFront = false;       ///< the panel stays before the person
};

/// A hand that points at the panel.
struct PanelTouch {
  ControllerSide side = ControllerSide::Right;
  double distance = 0.0;  ///< from the hand along its aim, metres of the room
  PanelPointer pointer;
};

/// The pose of the panel P in the room R, and the hand that points at it. P: x right, y up, z towards the person, the
/// origin in the middle; metres of the room, whatever the scale of the world is.
///
/// The panel stands over the other hand, or stays at the place before the person where it was put. Squeeze and trigger
/// of a hand that points at the panel have no other effect. A trigger that was pressed before is no press of the panel.
/// A press that began at the panel stays with it until the trigger is released, so that a slider can be dragged past
/// its end.
class PanelInRoom {
 public:
  static constexpr double kWidth = 0.40;
  static constexpr double kHeight = 0.32;
  /// Distance of the panel from the head, if it stays before the person.
  static constexpr double kDistance = 0.6;

  /// Advances to the present input. The squeeze and trigger that the panel takes are cleared in `states`.
  void advance(BothControllers& states, const PanelInput& input);
  /// Nothing if the panel is in a hand that is not tracked.
  const std::optional<Pose>& X_RP() const { return X_RP_; }
  const std::optional<PanelTouch>& touch() const { return touch_; }

 private:
  void place(const BothControllers& states, const PanelInput& input);
  std::optional<PanelTouch> touchOf(const ControllerState& state, ControllerSide side) const;

  std::optional<Pose> X_RP_;
  bool isInFront_ = false;
  std::optional<PanelTouch> touch_;
  bool wasReleased_ = false;  ///< the trigger was released since the hand points at the panel
};

}  // namespace glissade
