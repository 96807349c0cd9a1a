#pragma once

#include <vector>

#include "engine/operator/hand_inputs.h"

namespace glissade {

/// The inputs and outputs that the program uses of each controller.
enum class ControllerAction { Grip, Aim, Squeeze, Trigger, Stick, Menu, Lower, Upper, StickClick, Pulse };
inline constexpr std::size_t kControllerActions = 10;

/// An action and the component of a controller that it is bound to, below the path of its hand.
struct ControllerBinding {
  ControllerSide side;
  ControllerAction action;
  const char* component;
};

/// The bindings that are suggested to a runtime for one kind of controllers.
struct ControllerProfile {
  const char* path;  ///< path of the interaction profile
  std::vector<ControllerBinding> bindings;
};

/// The profiles of OpenXR's simple controller, of Oculus Touch, Valve Index, HTC Vive and Windows Mixed Reality. If a
/// controller has no squeeze, its only button is also the squeeze.
std::vector<ControllerProfile> controllerProfiles();

}  // namespace glissade
