#include "widgets/openxr/room_placement.h"

#include <cmath>
#include <numbers>

namespace glissade {
namespace {

/// Lengths in metres of the room.
constexpr double kTableHeight = 0.75;
constexpr double kTableSize = 0.6;      ///< largest size of a product on the table
constexpr double kTableDistance = 0.5;  ///< from the person to a product on the table
constexpr double kFloorDistance = 1.2;  ///< from the person to a product on the floor
constexpr double kEyeHeight = 1.6;      ///< of a person who stands upright
constexpr double kLowest = 1.0;         ///< least height of a product that stands on the floor

/// Turns y up into z up: the direction before the person is the y axis of the world.
Quaternion roomToWorld() { return Quaternion(Eigen::AngleAxisd(std::numbers::pi / 2.0, Vector3::UnitX())); }

}  // namespace

RoomPlacement placeRoom(const Box3& box, ProductSize size) {
  const Box3 product = box.isEmpty() ? Box3(Vector3::Zero(), Vector3::Zero()) : box;
  const double largest = product.sizes().maxCoeff();
  RoomPlacement room;
  if (size == ProductSize::OnTable && largest > 0.0) room.scale = kTableSize / largest;
  const bool stands = size == ProductSize::True && product.sizes().z() >= kLowest;
  const double distance = (stands ? kFloorDistance : kTableDistance) / room.scale;
  const double height = box.isEmpty() || stands ? 0.0 : kTableHeight / room.scale;
  room.X_WR.orientation = roomToWorld();
  room.X_WR.position = {product.center().x(), product.min().y() - distance, product.min().z() - height};
  return room;
}

RoomPlacement placeRoomAt(const Vector3& eye_W, const Vector3& ahead_W, double scale) {
  const double heading = std::atan2(-ahead_W.x(), ahead_W.y());
  RoomPlacement room;
  room.scale = scale;
  room.X_WR.orientation = Quaternion(Eigen::AngleAxisd(heading, Vector3::UnitZ())) * roomToWorld();
  room.X_WR.position = eye_W - kEyeHeight / scale * Vector3::UnitZ();
  return room;
}

Pose inWorld(const RoomPlacement& room, const Pose& X_RP) {
  return room.X_WR * Pose{X_RP.position / room.scale, X_RP.orientation};
}

Vector3 inRoom(const RoomPlacement& room, const Vector3& p_W) { return room.scale * (inverse(room.X_WR) * p_W); }

}  // namespace glissade
