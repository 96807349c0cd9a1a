#pragma once

#include <cstdint>

#include "engine/sequence/motion_world.h"
#include "engine/sequence/removal_trial.h"

namespace glissade {

/// Removal by the automatic planner. Its budget is counted in work, mainly in pairs of the kernel (QueryCounts::pairs):
/// the answer then does not depend on the machine, and a body with cheap queries gets more steps.
class SearchedRemoval {
 public:
  SearchedRemoval(const AssembledProduct& product, const ProductFits& fits, MotionWorlds& worlds, std::uint64_t seed)
      : product_(product), fits_(fits), worlds_(worlds), seed_(seed) {}

  /// The path begins at `start`, a configuration of MovingObject's frame. `work`: limit of the planner's work. The
  /// refusal names no bodies, because a search does not know what blocked it.
  RemovalAnswer tryRemoval(const BodyGroup& group, const BodySet& present, const Pose& start, std::uint64_t work,
                           const StopToken& stop) const;
  /// Calls the function above with the pose where the product is assembled.
  RemovalAnswer tryRemoval(const BodyGroup& group, const BodySet& present, std::uint64_t work,
                           const StopToken& stop) const;

 private:
  std::uint64_t seedOf(const BodyGroup& group, const BodySet& present, std::uint64_t work) const;

  const AssembledProduct& product_;
  const ProductFits& fits_;
  MotionWorlds& worlds_;
  std::uint64_t seed_;
};

}  // namespace glissade
