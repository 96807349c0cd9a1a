#pragma once

#include "engine/sequence/motion_world.h"
#include "engine/sequence/removal_trial.h"

namespace glissade {

/// Removal of a group that is in threads: turned out of them by a screw motion, then straight on along their axis.
class TurnedRemoval {
 public:
  TurnedRemoval(const ProductFits& fits, MotionWorlds& worlds) : fits_(fits), worlds_(worlds) {}

  /// As RemovalTrial::tryRemoval(). A group that is in no thread is refused by nobody.
  RemovalAnswer tryRemoval(const BodyGroup& group, const BodySet& present, const StopToken& stop) const;

 private:
  const ProductFits& fits_;
  MotionWorlds& worlds_;
};

}  // namespace glissade
