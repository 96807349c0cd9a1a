#pragma once

#include <map>
#include <mutex>
#include <optional>

#include "engine/sequence/motion_world.h"
#include "engine/sequence/removal_trial.h"

namespace glissade {

/// Removal of a group that is in threads: turned out of them by a screw motion, then straight on along their axis.
/// A refusal holds while those that it names are there, and is not searched again. May be asked by several threads at a
/// time.
class TurnedRemoval {
 public:
  TurnedRemoval(const ProductFits& fits, MotionWorlds& worlds) : fits_(fits), worlds_(worlds) {}

  /// As RemovalTrial::tryRemoval(). A group that is in no thread is refused by nobody.
  RemovalAnswer tryRemoval(const BodyGroup& group, const BodySet& present, const StopToken& stop);
  /// It is known that no screw motion leads the group out of its threads: no other motion does.
  bool isHeld(const BodyGroup& group, const BodySet& present) const;

 private:
  struct Known {
    std::vector<std::size_t> blockedBy;
    bool held = false;  ///< no screw motion is free at all
  };
  std::optional<Known> known(const BodyGroup& group, const BodySet& present) const;
  void remember(const BodyGroup& group, const Known& refusal);

  const ProductFits& fits_;
  MotionWorlds& worlds_;
  mutable std::mutex mutex_;            ///< of what follows
  std::map<BodyGroup, Known> refused_;  ///< the last refusal
};

}  // namespace glissade
