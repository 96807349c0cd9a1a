#include "widgets/openxr/eye_sight.h"

namespace glissade {
namespace {

/// Distances of the planes, in metres of the room.
constexpr double kNear = 0.05;
constexpr double kFar = 1000.0;

}  // namespace

EyeSight sightOf(const RoomPlacement& room, const Pose& X_RE, const EyeSides& sides) {
  return {inWorld(room, X_RE), sides, kNear / room.scale, kFar / room.scale};
}

}  // namespace glissade
