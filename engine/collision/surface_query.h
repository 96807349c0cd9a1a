#pragma once

#include <limits>
#include <optional>

#include "engine/collision/collision_query.h"

namespace glissade {

/// Queries of surfaces that a collision library answers for a world. Containment is not detected. One per thread.
class SurfaceQuery {
 public:
  virtual ~SurfaceQuery() = default;

  virtual bool touches(const Pose& X_WB) = 0;
  /// Lowest index of an obstacle whose surface touches the object's.
  virtual std::optional<int> touchingBody(const Pose& X_WB) = 0;
  /// The nearest pair if it is nearer than `enough`, else that distance without a pair (body -1).
  /// Precondition: the surfaces do not touch.
  virtual NearestObstacle nearest(const Pose& X_WB, double enough) = 0;
  /// True if the surfaces touch, or some pair is within `bound`.
  virtual bool isWithin(const Pose& X_WB, double bound) = 0;
  /// Like CollisionQuery::checkMotion, for the surfaces; nothing from a library without this function.
  virtual std::optional<MotionCheck> checkMotion(const Pose& from, const Pose& to, double required, SeekViolation seek,
                                                 const StopToken& stop) = 0;
  /// Number of pairs tested so far (QueryCounts::pairs).
  virtual std::uint64_t pairs() const { return 0; }
};

}  // namespace glissade
