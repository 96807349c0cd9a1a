#pragma once

#include <memory>

#include "engine/base/random_stream.h"
#include "engine/planning/automatic/eroded_worlds.h"

namespace glissade {

/// Makes the configurations that a hand shows free: a configuration that touches or penetrates is retracted to a small
/// clearance, by the distances of eroded objects (retraction.h) and then of the object itself. Used by one thread.
class ShownConfiguration {
 public:
  /// Longest move of a configuration, in radii of the object, in the metric.
  static constexpr double kMostMoved = 0.5;

  /// `attempts`: number of other configurations nearby that are tried where one cannot be retracted.
  ShownConfiguration(const Problem& problem, std::shared_ptr<ErodedWorlds> worlds, std::uint64_t seed, int attempts);

  struct ClearConfiguration {
    Pose q;
    NearestObstacle nearest;  ///< nearest obstacle at q; distance above 0
    double moved = 0.0;       ///< distance from the shown configuration, metres in the metric; 0 where that was free
  };
  /// The free configuration; nothing where none was found within the bound. `clearance`: clearance of a retracted
  /// configuration, metres.
  std::optional<ClearConfiguration> clearConfiguration(const Pose& q, double clearance);
  /// The free configuration alone, without its nearest obstacle: cheaper where q is free.
  std::optional<Pose> clearPose(const Pose& q, double clearance);

  /// Counts of all its queries.
  QueryCounts counts() const;

 private:
  std::optional<Pose> retractedFrom(const Pose& q, const Pose& shown, double clearance);

  CollisionWorldPtr world_;
  Box3 bounds_;
  Se3Metric metric_;
  std::shared_ptr<ErodedWorlds> worlds_;
  RandomStream stream_;
  int attempts_;
  std::unique_ptr<CollisionQuery> query_;
  std::vector<std::unique_ptr<CollisionQuery>> eroded_;  ///< one query per depth; null until it is needed
};

}  // namespace glissade
