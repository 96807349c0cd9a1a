#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "engine/planning/path.h"

namespace glissade {

/// A part of a motion that goes in one direction and turns about one axis.
struct MotionLeg {
  Vector3 direction = Vector3::Zero();  ///< unit, world; zero where it only turns
  double length = 0.0;                  ///< metres
  Vector3 axis = Vector3::Zero();       ///< unit, world; zero where it does not turn
  double turn = 0.0;                    ///< radians
};

/// The motion as legs: consecutive edges of the same direction and axis are one.
std::vector<MotionLeg> legsOf(const std::vector<PathPoint>& path);

/// The legs of the motion from its end to its beginning.
std::vector<MotionLeg> reversed(const std::vector<MotionLeg>& legs);

/// Unit direction in which the motion begins; zero where it only turns.
Vector3 firstDirection(const std::vector<PathPoint>& path);

/// Unit direction from the first to the last position; up if they are equal.
Vector3 exitDirection(const std::vector<PathPoint>& path);

/// Unit vector of "+x", "-x", "+y", "-y", "+z" or "-z"; nothing for another text.
std::optional<Vector3> axisNamed(std::string_view text);

}  // namespace glissade
