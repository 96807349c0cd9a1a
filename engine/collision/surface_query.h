#pragma once

#include <limits>
#include <optional>

#include "engine/collision/collision_query.h"

namespace glissade {

/// What a collision library has to answer for a world: the surfaces alone, containment is not seen.
/// One per thread.
class SurfaceQuery {
 public:
  virtual ~SurfaceQuery() = default;

  virtual bool touches(const Pose& X_WB) = 0;
  /// The lowest obstacle whose surface touches the object's.
  virtual std::optional<int> touchingBody(const Pose& X_WB) = 0;
  /// The nearest pair if it is nearer than `enough`, else that distance without a pair (body -1).
  /// Precondition: the surfaces do not touch.
  virtual NearestObstacle nearest(const Pose& X_WB, double enough) = 0;
  /// The surfaces touch, or some pair is at `bound` or nearer.
  virtual bool isWithin(const Pose& X_WB, double bound) = 0;
  /// As CollisionQuery::checkMotion, of the surfaces; nothing from a library that cannot.
  virtual std::optional<MotionCheck> checkMotion(const Pose& from, const Pose& to, double required, SeekViolation seek,
                                                 const StopToken& stop) = 0;
  /// Looked at so far (QueryCounts::pairs).
  virtual std::uint64_t pairs() const { return 0; }
};

}  // namespace glissade
