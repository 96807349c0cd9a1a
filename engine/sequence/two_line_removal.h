#pragma once

#include "engine/sequence/motion_world.h"
#include "engine/sequence/removal_trial.h"

namespace glissade {

/// The method of such steps (AssemblyStep::method).
inline constexpr const char* kTwoLines = "two lines";

/// Removal along two straight lines: out of its place along one of the directions of removalDirections(), then out of
/// the product along another one, as a screw is drawn out of its hole and taken away beside what stands over it. May be
/// asked by several threads at a time.
class TwoLineRemoval {
 public:
  /// Refers to all.
  TwoLineRemoval(const AssembledProduct& product, const ProductFits& fits, MotionWorlds& worlds)
      : product_(product), fits_(fits), worlds_(worlds) {}

  /// As RemovalTrial::tryRemoval(). The refusal names nobody.
  RemovalAnswer tryRemoval(const BodyGroup& group, const BodySet& present, const StopToken& stop) const;

 private:
  std::vector<Vector3> directionsOf(const BodyGroup& group) const;

  const AssembledProduct& product_;
  const ProductFits& fits_;
  MotionWorlds& worlds_;
};

}  // namespace glissade
