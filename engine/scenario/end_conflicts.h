#pragma once

#include <optional>
#include <vector>

#include "engine/scenario/scenario.h"

namespace glissade {

/// An obstacle that the object may not be as near to as it is at one of its ends.
struct EndConflict {
  std::size_t obstacle = 0;       ///< index
  std::optional<double> overlap;  ///< metres; nothing: not known, because a mesh is not closed or the bodies touch only
  double distance = 0.0;          ///< metres, below what is required; 0 where they touch or overlap
  std::vector<Vector3> cut;       ///< where the two surfaces meet: ends of segments, world frame
};

/// Why a planner refuses the start or the goal.
struct EndConflicts {
  bool atStart = true;  ///< else at the goal
  Pose q;               ///< the object there
  std::vector<EndConflict> conflicts;
};

/// The obstacles that the object overlaps, touches, or is nearer to than `required` (metres), at its start or, where
/// that is free, at its goal; fits that are allowed do not count. By overlap, the largest first. Nothing where both
/// ends are free. On any thread; after a stop the list is incomplete.
std::optional<EndConflicts> findEndConflicts(const LoadedScenario& scenario, double required,
                                             const StopToken& stop = {});

}  // namespace glissade
