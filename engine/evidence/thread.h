#pragma once

#include "engine/base/message.h"
#include "engine/geometry/pose.h"

namespace glissade::evidence {

/// A thread of the moving body and another one. While it is engaged, the body turns about the axis and advances by the
/// pitch, and has no other motion. World frame.
struct Thread {
  std::size_t other = 0;            ///< number of the other body
  Vector3 point = Vector3::Zero();  ///< on the axis
  Vector3 axis = Vector3::UnitZ();  ///< unit
  double pitch = 0.0;               ///< metres along the axis for a turn about it; below 0: left-handed
  double radiusMoving = 0.0;        ///< radius of the cylinder that represents the thread of the moving body, metres
  double radiusOther = 0.0;         ///< radius of the cylinder of the other body, metres
  bool movingIsShaft = true;        ///< true: the other body has the hole
  bool mayTurn = true;              ///< false: a person says that the other body is the one that is turned
  Pose assembled;                   ///< configuration of the moving body in which its thread is on the axis
};

/// A thread as a file states it, in the world frame where the product is assembled.
struct StatedThread {
  Vector3 point = Vector3::Zero();
  Vector3 direction = Vector3::UnitZ();
  double pitch = 0.0;
  double radiusMoving = 0.0;
  double radiusOther = 0.0;
};

/// Largest deviation of a point of the thread from the exact turn, as a share of the pitch.
inline constexpr double kThreadPlay = 0.02;

/// Least pitch of a thread that is made, metres.
inline constexpr double kLeastThreadPitch = 1e-5;
/// Largest pitch, in diameters: a thread with several starts advances by no more in a turn.
inline constexpr double kMostPitchInDiameters = 2.0;

/// The reason why this is no pitch of a thread with these radii; empty if it is one.
Message wrongPitch(const Thread& thread);

}  // namespace glissade::evidence
