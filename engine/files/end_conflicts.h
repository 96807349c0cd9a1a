#pragma once

#include <optional>
#include <vector>

#include "engine/files/scenario.h"

namespace glissade {

/// An obstacle that is too near to the object at one of its ends.
struct EndConflict {
  std::size_t obstacle = 0;  ///< index of the obstacle
  /// Depth of the overlap, metres; nothing: not known, because a mesh is not closed or the bodies only touch.
  std::optional<double> overlap;
  double distance = 0.0;     ///< distance below the required clearance, metres; 0 where they touch or overlap
  std::vector<Vector3> cut;  ///< intersection curve of the two surfaces: ends of segments, world frame
};

/// The reasons why a planner refuses the start or the goal.
struct EndConflicts {
  bool atStart = true;  ///< true: at the start; false: at the goal
  Pose q;               ///< configuration of the object at that end
  std::vector<EndConflict> conflicts;
};

/// The obstacles that the object overlaps, touches, or is nearer to than `required` (metres), at its start or, where
/// that is free, at its goal. Allowed fits do not count. Sorted by overlap, the largest first. Nothing where both ends
/// are free. On any thread; after a stop the list is incomplete.
std::optional<EndConflicts> findEndConflicts(const LoadedScenario& scenario, double required,
                                             const StopToken& stop = {});

}  // namespace glissade
