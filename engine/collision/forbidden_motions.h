#pragma once

#include "engine/geometry/pose.h"

namespace glissade {

/// Motions that a person forbids to the object of a world, beside what is in its way. Immutable, shared by threads.
class ForbiddenMotions {
 public:
  virtual ~ForbiddenMotions() = default;

  /// The object may be here.
  virtual bool mayBeAt(const Pose& X_WB) const = 0;
  /// The object may go by this straight motion, in this direction. False where it may not be at `to`.
  virtual bool mayMove(const Pose& from, const Pose& to) const = 0;
};

}  // namespace glissade
