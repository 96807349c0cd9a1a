#pragma once

#include <vector>

#include "engine/operator/hand_inputs.h"

namespace glissade {

/// What the program asks of each controller.
enum class ControllerAction { Grip, Aim, Squeeze, Trigger, Stick, Menu, Lower, Upper, StickClick, Pulse };
inline constexpr std::size_t kControllerActions = 10;

/// An action and what of a controller it is bound to, below the path of its hand.
struct ControllerBinding {
  ControllerSide side;
  ControllerAction action;
  const char* component;
};

/// What is suggested to a runtime for a kind of controllers.
struct ControllerProfile {
  const char* path;  ///< of the interaction profile
  std::vector<ControllerBinding> bindings;
};

/// Those of the simple controller of OpenXR, of Oculus Touch, Valve Index, HTC Vive and Windows Mixed Reality. Where a
/// controller has no squeeze, its only button is the squeeze, too.
std::vector<ControllerProfile> controllerProfiles();

}  // namespace glissade
