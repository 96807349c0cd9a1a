#pragma once

#include "engine/geometry/pose.h"

namespace glissade::check {

/// A thread that the moving body has in common with another one: while it is engaged, the body turns about the axis and
/// advances by the pitch, and moves in no other way. World frame.
struct Thread {
  std::size_t other = 0;            ///< number of the other body
  Vector3 point = Vector3::Zero();  ///< on the axis
  Vector3 axis = Vector3::UnitZ();  ///< unit
  double pitch = 0.0;               ///< metres along the axis for a turn about it; below 0: left-handed
  double radiusMoving = 0.0;        ///< of the cylinder that stands for the thread of the moving body, metres
  double radiusOther = 0.0;         ///< the same of the other one
  bool movingIsShaft = true;        ///< the other one has the hole then
  bool mayTurn = true;              ///< false: a person says that the other body is the one that is turned
  Pose assembled;                   ///< configuration of the moving body in which its thread is on the axis
};

/// Share of the pitch by which a point of the thread may be off the exact turn.
inline constexpr double kThreadPlay = 0.02;

}  // namespace glissade::check
