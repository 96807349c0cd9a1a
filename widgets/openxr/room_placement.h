#pragma once

#include "engine/geometry/pose.h"

namespace glissade {

/// The pose and scale of the person's room R in the world W. R is OpenXR's: x right, y up, z towards the person, the
/// origin on the floor where they stand at first. The world is z up.
struct RoomPlacement {
  Pose X_WR;           ///< lengths in metres of the world
  double scale = 1.0;  ///< metres of the room for each metre of the world
};

/// The size in which the product is shown.
enum class ProductSize { True, OnTable };

/// Places the person before the front of `box`, which stands on the floor, or on a table if it is low.
/// `ProductSize::OnTable` scales it to the size of the table. If the box is empty, the origin of the world is on the
/// floor before the person.
RoomPlacement placeRoom(const Box3& box, ProductSize size);

/// Places the person so that their eyes, if they stand upright, are at `eye_W`. They look along `ahead_W`, which is not
/// vertical.
RoomPlacement placeRoomAt(const Vector3& eye_W, const Vector3& ahead_W, double scale);

/// Converts a pose from the room to the world.
Pose inWorld(const RoomPlacement& room, const Pose& X_RP);

/// Converts a point from the world to the room.
Vector3 inRoom(const RoomPlacement& room, const Vector3& p_W);

}  // namespace glissade
