#include "widgets/openxr/panel_in_room.h"

#include <algorithm>
#include <cmath>

#include "widgets/openxr/controller_link.h"

namespace glissade {
namespace {

/// Pose over the hand, leaned back so that a person who looks down at the panel sees it straight.
const Pose kInHand{Vector3(0.0, 0.21, -0.08), Quaternion(Eigen::AngleAxisd(-0.5, Vector3::UnitX()))};
/// Height of the eyes above the panel, metres of the room.
constexpr double kBelow = 0.2;

/// The pose before a head that looks this way: upright, and leaned towards the eyes.
Pose beforeHead(const Pose& X_RH) {
  const Vector3 forward = X_RH.orientation * -Vector3::UnitZ();
  const double azimuth = std::atan2(-forward.x(), -forward.z());
  const Quaternion turned(Eigen::AngleAxisd(azimuth, Vector3::UnitY()));
  const double lean = std::asin(kBelow / PanelInRoom::kDistance);
  const Vector3 p_HP(0.0, -kBelow, -std::cos(lean) * PanelInRoom::kDistance);
  return {X_RH.position + turned * p_HP, turned * Quaternion(Eigen::AngleAxisd(-lean, Vector3::UnitX()))};
}

bool isOn(const PanelPointer& pointer) { return pointer.at.minCoeff() >= 0.0 && pointer.at.maxCoeff() <= 1.0; }

}  // namespace

void PanelInRoom::advance(BothControllers& states, const PanelInput& input) {
  place(states, input);
  std::optional<PanelTouch> found;
  const ControllerSide other = input.mainHand == ControllerSide::Left ? ControllerSide::Right : ControllerSide::Left;
  for (const ControllerSide side : {input.mainHand, other}) {
    const auto i = static_cast<std::size_t>(side);
    const bool carriesPanel = side == other && !input.isInFront;
    if (!found && !carriesPanel && !input.holds[i]) found = touchOf(states[i], side);
  }
  if (!found || !touch_ || found->side != touch_->side) wasReleased_ = false;
  touch_ = found;
  if (!touch_) return;
  ControllerState& taken = states[static_cast<std::size_t>(touch_->side)];
  wasReleased_ = wasReleased_ || taken.trigger < ControllerLink::kTriggerReleased;
  taken.squeeze = 0.0;
  taken.trigger = 0.0;
}

void PanelInRoom::place(const BothControllers& states, const PanelInput& input) {
  if (input.isInFront) {
    if (!isInFront_) X_RP_ = beforeHead(input.X_RH);
  } else {
    const std::size_t other = input.mainHand == ControllerSide::Left ? 1 : 0;
    const std::optional<Pose>& X_RG = states[other].X_RG;
    X_RP_ = X_RG ? std::optional(*X_RG * kInHand) : std::nullopt;
  }
  isInFront_ = input.isInFront;
}

/// The point at which the hand points. A hand that has pressed the panel points at it until it releases.
std::optional<PanelTouch> PanelInRoom::touchOf(const ControllerState& state, ControllerSide side) const {
  if (!X_RP_ || !state.X_RA) return std::nullopt;
  const bool drags = touch_ && touch_->side == side && touch_->pointer.pressed;
  const Pose X_PA = inverse(*X_RP_) * *state.X_RA;
  const Vector3 direction = X_PA.orientation * -Vector3::UnitZ();
  const double distance = -X_PA.position.z() / direction.z();
  if (direction.z() >= 0.0 || distance < 0.0) return std::nullopt;
  const Vector3 p_P = X_PA.position + distance * direction;
  PanelTouch touch{side, distance, {{p_P.x() / kWidth + 0.5, 0.5 - p_P.y() / kHeight}, false}};
  if (!drags && !isOn(touch.pointer)) return std::nullopt;
  const double least = drags ? ControllerLink::kTriggerReleased : ControllerLink::kTriggerPressed;
  touch.pointer.pressed = touch_ && touch_->side == side && wasReleased_ && state.trigger >= least;
  touch.pointer.at = touch.pointer.at.cwiseMax(0.0).cwiseMin(1.0);
  return touch;
}

}  // namespace glissade
