#pragma once

#include "widgets/headset/room_placement.h"

namespace glissade {

/// The sides of a picture as an eye sees them: tangents of the angles from its line of sight; left and down are
/// negative where the line of sight meets the picture.
struct EyeSides {
  double left = -1.0;
  double right = 1.0;
  double down = -1.0;
  double up = 1.0;
};

/// From where and how an eye E sees the world W. E: x right, y up, z from what is seen to the eye; metres of the world.
struct EyeSight {
  Pose X_WE;
  EyeSides sides;
  double nearPlane = 0.05;
  double farPlane = 1000.0;
};

/// Of an eye that is in the room. The planes are those of the room: nothing nearer than 5 cm or farther than 1 km is
/// seen.
EyeSight sightOf(const RoomPlacement& room, const Pose& X_RE, const EyeSides& sides);

}  // namespace glissade
