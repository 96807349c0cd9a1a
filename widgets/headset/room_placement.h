#pragma once

#include "engine/geometry/pose.h"

namespace glissade {

/// How the room R of the person lies in the world W. R is OpenXR's: x right, y up, z to the person, the origin on the
/// floor where they stand at first. The world is z up.
struct RoomPlacement {
  Pose X_WR;           ///< lengths in metres of the world
  double scale = 1.0;  ///< metres of the room for each metre of the world
};

/// How large the product is shown.
enum class ProductSize { True, OnTable };

/// The person stands before the front of what lies in `box`, which stands on the floor, or on a table where it is low.
/// On a table, `ProductSize::OnTable`, it is as large as the table has room for. An empty box: the origin of the world
/// is on the floor before the person.
RoomPlacement placeRoom(const Box3& box, ProductSize size);

/// A pose in the room, in the world.
Pose inWorld(const RoomPlacement& room, const Pose& X_RP);

/// A point of the world, in the room.
Vector3 inRoom(const RoomPlacement& room, const Vector3& p_W);

}  // namespace glissade
