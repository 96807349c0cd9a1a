#pragma once

#include <array>
#include <vector>

#include "engine/operator/hand_inputs.h"
#include "widgets/headset/flat_picture.h"

namespace glissade {

/// What is drawn of a controller.
struct ShownController {
  ControllerReading reading;
  ControllerFeedback feedback;
};
using ShownControllers = std::array<ShownController, 2>;  ///< by ControllerSide

/// A picture that stands in the scene: P x right, y up, z to who sees it, the origin in its middle.
struct ShownPicture {
  std::optional<Pose> X_WP{};  ///< nothing: it is not drawn
  double width = 0.0;          ///< metres of the room
  double height = 0.0;
  FlatPicturePtr picture{};  ///< null: it is not drawn
};

/// What is drawn of the hands of a person.
struct ShownHands {
  ShownControllers controllers;
  std::optional<Vector3> p_WT{};  ///< where the person would stand; nothing: they do not ask for it
  double scale = 1.0;             ///< metres of the room for each metre of the world
  ShownPicture panel{};
  std::vector<ShownPicture> texts{};  ///< over everything that is seen
};

}  // namespace glissade
