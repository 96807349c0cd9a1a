#pragma once

#include <glissade/pose.h>

#include <cstdint>
#include <functional>

namespace glissade::api {

/// The state that an operator from outside sees when it moves the object.
struct HandView {
  Pose hand{};             ///< pose of the object in the hand, X_WB
  double seconds = 0.0;    ///< time until the next call, by the operator's clock
  double clearance = 0.0;  ///< distance to the nearest obstacle, metres; 0 in contact, infinite without obstacles
  std::uint64_t contactNodes = 0;  ///< nodes from contact sampling so far: while it grows, the tree slides on a surface
};

/// A simulated operator: the pose of the object in the hand after the seconds of the view. It is called once for each
/// planner step. The position is limited to the bounds of the problem. An invalid pose or an exception ends the run.
using OperatorFunction = std::function<Pose(const HandView&)>;

}  // namespace glissade::api
