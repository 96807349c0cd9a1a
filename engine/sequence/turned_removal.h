#pragma once

#include <map>
#include <mutex>
#include <optional>

#include "engine/sequence/motion_world.h"
#include "engine/sequence/removal_trial.h"

namespace glissade {

/// Removal of a group that is in threads: a screw motion out of them, then straight on along their axis. A refusal
/// holds while the bodies that it names are there, and is stored. Thread-safe.
class TurnedRemoval {
 public:
  TurnedRemoval(const ProductFits& fits, MotionWorlds& worlds) : fits_(fits), worlds_(worlds) {}

  /// See RemovalTrial::tryRemoval(). For a group that is in no thread, the refusal names no body.
  RemovalAnswer tryRemoval(const BodyGroup& group, const BodySet& present, const StopToken& stop);
  /// True if an earlier search found that no screw motion leads the group out of its threads: no other motion does.
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
  mutable std::mutex mutex_;            ///< protects the members below
  std::map<BodyGroup, Known> refused_;  ///< the last refusal of each group
};

}  // namespace glissade
