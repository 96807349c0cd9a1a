#pragma once

#include <memory>
#include <vector>

#include "engine/collision/collision_query.h"

namespace glissade {

/// Obstacles that share a variant of the object, as a world of their own.
struct ObstacleGroup {
  CollisionWorldPtr world;
  std::vector<int> bodies;  ///< the group's obstacles as the whole world numbers them, ascending
};

/// Asks every group whose box the object may reach and unites the answers: what is said of the object is said of each
/// variant against its own obstacles.
class GroupedQuery final : public CollisionQuery {
 public:
  /// The motion bound is that of the whole object, which holds the variants.
  GroupedQuery(const std::vector<ObstacleGroup>& groups, std::shared_ptr<const MotionBound> motionBound);

  bool collides(const Pose& X_WB) override;
  std::optional<int> collidingBody(const Pose& X_WB) override;
  NearestObstacle nearestObstacle(const Pose& X_WB) override;
  double distanceUpTo(const Pose& X_WB, double enough) override;
  bool clearAbove(const Pose& X_WB, double bound) override;
  MotionCheck checkMotion(const Pose& from, const Pose& to, double required, SeekViolation seek,
                          const StopToken& stop) override;
  double screwClearance(const Pose& from, const ScrewAxis& screw, double advance, double enough, double off) override;

  const MotionBound& motionBound() const override { return *motionBound_; }
  QueryCounts counts() const override;

 private:
  struct Part {
    std::unique_ptr<CollisionQuery> query;
    std::vector<int> bodies;
    Box3 box;            ///< of the group's obstacles
    double coordinates;  ///< the largest of them
  };

  double leastDistance(const Part& part, const Pose& X_WB) const;
  double lessRounding(const Part& part, double distance, const Vector3& position) const;
  bool mayReach(const Part& part, const Pose& from, const Pose& to, double required) const;

  std::vector<Part> parts_;
  std::shared_ptr<const MotionBound> motionBound_;
  QueryCounts counts_;
  std::size_t lastNearest_ = 0;
};

}  // namespace glissade
