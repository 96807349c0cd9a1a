#pragma once

#include "engine/geometry/pose.h"

namespace glissade {

/// Motions that a person forbids to the object of a world, in addition to the obstacles. Immutable, shared by threads.
class ForbiddenMotions {
 public:
  virtual ~ForbiddenMotions() = default;

  /// True if the object may be at this pose.
  virtual bool mayBeAt(const Pose& X_WB) const = 0;
  /// True if the object may make this straight motion in this direction. False where it may not be at `to`.
  virtual bool mayMove(const Pose& from, const Pose& to) const = 0;
};

}  // namespace glissade
