#pragma once

#include "widgets/openxr/room_placement.h"

namespace glissade {

/// The sides of an eye's picture, as tangents of the angles from its line of sight; left and down are negative if the
/// line of sight meets the picture.
struct EyeSides {
  double left = -1.0;
  double right = 1.0;
  double down = -1.0;
  double up = 1.0;
};

/// The pose of an eye E in the world W, and its projection. E: x right, y up, z towards the viewer; metres of the
/// world.
struct EyeSight {
  Pose X_WE;
  EyeSides sides;
  double nearPlane = 0.05;
  double farPlane = 1000.0;
};

/// The sight of an eye in the room. Its planes are fixed in the room: it sees from 5 cm to 1 km.
EyeSight sightOf(const RoomPlacement& room, const Pose& X_RE, const EyeSides& sides);

}  // namespace glissade
