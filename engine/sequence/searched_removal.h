#pragma once

#include <cstdint>

#include "engine/sequence/motion_world.h"
#include "engine/sequence/removal_trial.h"

namespace glissade {

/// Removal by the automatic planner. Budgets are counted in its work, above all in pairs of the kernel
/// (QueryCounts::pairs), so that the answer does not depend on the machine, and a body that is cheap to ask for gets
/// more steps than one that is not.
class SearchedRemoval {
 public:
  SearchedRemoval(const AssembledProduct& product, const ProductFits& fits, MotionWorlds& worlds, std::uint64_t seed)
      : product_(product), fits_(fits), worlds_(worlds), seed_(seed) {}

  /// `work` of the planner at most. The refusal names nobody: a search does not know who was in its way.
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
