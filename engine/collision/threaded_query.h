#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/collision/collision_query.h"
#include "engine/collision/thread_rule.h"

namespace glissade {

/// The data of a world with threads that queries need: the pairs, and the world of the whole object with the obstacles
/// of the threads.
struct ThreadedWorld {
  std::vector<ThreadPair> pairs;
  CollisionWorldPtr whole;
};

/// Holds the rule of threads (ThreadRule). While a pair is engaged, configurations off its screw motion count as a
/// collision with the pair's obstacle. While none is, the object is whole against their obstacles.
class ThreadedQuery final : public CollisionQuery {
 public:
  /// `screwed` has the object thinned against the obstacles of the pairs.
  ThreadedQuery(std::unique_ptr<CollisionQuery> screwed, std::shared_ptr<const ThreadedWorld> threads);

  bool collides(const Pose& X_WB) override;
  std::optional<int> collidingBody(const Pose& X_WB) override;
  NearestObstacle nearestObstacle(const Pose& X_WB) override;
  double distanceUpTo(const Pose& X_WB, double enough) override;
  bool clearAbove(const Pose& X_WB, double bound) override;
  MotionCheck checkMotion(const Pose& from, const Pose& to, double required, SeekViolation seek,
                          const StopToken& stop) override;
  double screwClearance(const Pose& from, const ScrewAxis& screw, double advance, double enough, double off) override;

  const MotionBound& motionBound() const override { return screwed_->motionBound(); }
  QueryCounts counts() const override;

 private:
  /// The query for the object in a configuration, or the obstacle of the thread that forbids the configuration.
  struct Taken {
    CollisionQuery* query = nullptr;
    int forbidding = -1;
  };
  Taken takenAt(const Pose& X_WB);
  bool neverEngaged(const ThreadPair& pair, const Pose& from, const Pose& to) const;
  std::optional<double> engagedAdvance(const Pose& from, const ScrewAxis& screw, double advance, double off) const;
  double firstForbidden(const Pose& from, const Pose& to);

  std::unique_ptr<CollisionQuery> screwed_;
  std::unique_ptr<CollisionQuery> whole_;
  std::shared_ptr<const ThreadedWorld> threads_;
  QueryCounts counts_;
};

}  // namespace glissade
