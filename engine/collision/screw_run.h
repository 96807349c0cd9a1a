#pragma once

#include <cstddef>
#include <vector>

#include "engine/geometry/screw_axis.h"

namespace glissade {

/// Consecutive edges of a path that are one screw motion of more than a full turn.
struct ScrewRun {
  std::size_t first = 0;  ///< index of the first edge
  std::size_t last = 0;   ///< index of the last edge
  ScrewAxis screw;
  double advance = 0.0;  ///< advance along the axis from the first configuration to the last, metres
  double off = 0.0;      ///< largest distance of any point of the object from the screw motion, metres
};

/// All screw runs of a path. `objectRadius`: metres about the reference point.
std::vector<ScrewRun> screwRunsOf(const std::vector<Pose>& path, double objectRadius);

}  // namespace glissade
