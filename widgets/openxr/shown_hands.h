#pragma once

#include <array>
#include <vector>

#include "engine/operator/hand_inputs.h"
#include "widgets/openxr/flat_picture.h"

namespace glissade {

/// The state of a controller that is drawn.
struct ShownController {
  ControllerReading reading;
  ControllerFeedback feedback;
};
using ShownControllers = std::array<ShownController, 2>;  ///< by ControllerSide

/// A picture in the scene: P x right, y up, z towards the viewer, the origin in its middle.
struct ShownPicture {
  std::optional<Pose> X_WP{};  ///< nothing: it is not drawn
  double width = 0.0;          ///< metres of the room
  double height = 0.0;
  FlatPicturePtr picture{};  ///< null: it is not drawn
};

/// The hands, the panel and the texts that are drawn for a person.
struct ShownHands {
  ShownControllers controllers;
  std::optional<Vector3> p_WT{};  ///< place where the person would stand; nothing: no stick is pushed
  double scale = 1.0;             ///< metres of the room for each metre of the world
  ShownPicture panel{};
  std::vector<ShownPicture> texts{};  ///< drawn over everything
};

}  // namespace glissade
