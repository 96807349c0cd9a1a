#pragma once

#include <memory>
#include <optional>

#include "engine/collision/collision_query.h"
#include "engine/collision/forbidden_regions.h"

namespace glissade {

/// Adds the rule of forbidden places and motions to another query. A configuration whose reference point is in a
/// forbidden place (ForbiddenRegions) counts as a collision with kForbiddenPlace, and so does a motion that meets one.
/// Distances are those to the obstacles; the places only keep their margin.
class ForbiddingQuery final : public CollisionQuery {
 public:
  ForbiddingQuery(std::unique_ptr<CollisionQuery> bodies, std::shared_ptr<const ForbiddenSpace> space);

  bool collides(const Pose& X_WB) override;
  std::optional<int> collidingBody(const Pose& X_WB) override;
  NearestObstacle nearestObstacle(const Pose& X_WB) override;
  double distanceUpTo(const Pose& X_WB, double enough) override;
  bool clearAbove(const Pose& X_WB, double bound) override;
  MotionCheck checkMotion(const Pose& from, const Pose& to, double required, SeekViolation seek,
                          const StopToken& stop) override;
  double screwClearance(const Pose& from, const ScrewAxis& screw, double advance, double enough, double off) override;
  std::optional<ForbiddenStretch> forbiddenOn(const Pose& from, const Pose& to) override;

  bool mayMove(const Pose& from, const Pose& to) override;
  double forbiddenMargin() override;

  const MotionBound& motionBound() const override { return bodies_->motionBound(); }
  QueryCounts counts() const override { return bodies_->counts(); }

 private:
  const ForbiddenRegions* regions();
  bool isForbidden(const Pose& X_WB);
  bool mayTouch(const Pose& from, const ScrewAxis& screw, double advance, double off);

  std::unique_ptr<CollisionQuery> bodies_;
  std::shared_ptr<const ForbiddenSpace> space_;
  ForbiddenRegionsPtr regions_;
  std::uint64_t seen_ = 0;
};

}  // namespace glissade
