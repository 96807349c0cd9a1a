#pragma once

#include "engine/sequence/motion_world.h"
#include "engine/sequence/removal_trial.h"

namespace glissade {

/// StepMotion::method of these motions.
inline constexpr const char* kTwoLines = "two lines";

/// Removal along two straight lines: along one of removalDirections() out of its place, then along another one out of
/// the product, as a screw is drawn out of its hole and taken away beside a part above it. Thread-safe.
class TwoLineRemoval {
 public:
  /// Refers to all arguments.
  TwoLineRemoval(const AssembledProduct& product, const ProductFits& fits, MotionWorlds& worlds)
      : product_(product), fits_(fits), worlds_(worlds) {}

  /// See RemovalTrial::tryRemoval(). The refusal names no body.
  RemovalAnswer tryRemoval(const BodyGroup& group, const BodySet& present, const StopToken& stop) const;
  /// The configurations of a free motion along two lines from `start`, with `start`; empty if none is free.
  std::vector<Pose> linesFrom(const Pose& start, const BodyGroup& group, const BodySet& present,
                              const StopToken& stop) const;

 private:
  std::vector<Vector3> directionsOf(const BodyGroup& group) const;

  const AssembledProduct& product_;
  const ProductFits& fits_;
  MotionWorlds& worlds_;
};

}  // namespace glissade
