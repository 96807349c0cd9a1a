#pragma once

#include <array>

#include "engine/operator/hand_inputs.h"

namespace glissade {

/// What is drawn of a controller.
struct ShownController {
  ControllerReading reading;
  ControllerFeedback feedback;
};
using ShownControllers = std::array<ShownController, 2>;  ///< by ControllerSide

/// What is drawn of the hands of a person.
struct ShownHands {
  ShownControllers controllers;
  std::optional<Vector3> p_WT{};  ///< where the person would stand; nothing: they do not ask for it
  double scale = 1.0;             ///< metres of the room for each metre of the world
};

}  // namespace glissade
