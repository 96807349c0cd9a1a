#pragma once

#include <array>
#include <optional>
#include <string>

#include "engine/operator/hand_inputs.h"

namespace glissade {

/// The state of a controller, in the room R.
struct ControllerState {
  std::string name;          ///< name of the profile by the runtime; empty if there is no controller
  std::optional<Pose> X_RG;  ///< grip G; nothing while it is not tracked
  std::optional<Pose> X_RA;  ///< aim A, along -z; nothing while it is not tracked
  double squeeze = 0.0;      ///< in [0, 1]
  double trigger = 0.0;      ///< in [0, 1]
  Eigen::Vector2d stick = Eigen::Vector2d::Zero();  ///< each in [-1, 1]; right and up
  std::array<bool, kControllerButtons> pressed{};   ///< by ControllerButton, without the trigger

  bool isPressed(ControllerButton button) const { return pressed[static_cast<std::size_t>(button)]; }
};

/// The states by ControllerSide.
using BothControllers = std::array<ControllerState, 2>;
inline constexpr std::array kBothSides{ControllerSide::Left, ControllerSide::Right};

}  // namespace glissade
