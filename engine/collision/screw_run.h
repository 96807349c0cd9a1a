#pragma once

#include <cstddef>
#include <vector>

#include "engine/geometry/screw_axis.h"

namespace glissade {

/// Edges of a path, one after the other, that are one screw motion of more than a full turn.
struct ScrewRun {
  std::size_t first = 0;  ///< edge
  std::size_t last = 0;   ///< edge, the last of them
  ScrewAxis screw;
  double advance = 0.0;  ///< metres along the axis, from the first configuration to the last
  double off = 0.0;      ///< metres that any point of the object is off the screw motion, at most
};

/// All of them, of a path of an object with this radius (metres) about its reference point.
std::vector<ScrewRun> screwRunsOf(const std::vector<Pose>& path, double objectRadius);

}  // namespace glissade
