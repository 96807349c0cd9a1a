#pragma once

#include <memory>

#include "engine/base/random_stream.h"
#include "engine/planning/automatic/eroded_worlds.h"

namespace glissade {

/// Makes what a hand shows free: a configuration that touches or penetrates is retracted to a small clearance, by the
/// distances of eroded objects (retraction.h) and then of the object itself. Used by one thread.
class ShownConfiguration {
 public:
  /// No configuration is moved by more than this, in radii of the object, in the metric.
  static constexpr double kMostMoved = 0.5;

  /// `attempts`: of a configuration that cannot be retracted, so many others near by are tried.
  ShownConfiguration(const Problem& problem, std::shared_ptr<ErodedWorlds> worlds, std::uint64_t seed, int attempts);

  struct Freed {
    Pose q;
    NearestObstacle nearest;  ///< of q; distance above 0
    double moved = 0.0;       ///< metres in the metric; 0 where q was free
  };
  /// Nothing where no free configuration was found within the bound. `clearance` in metres is what a retracted one
  /// keeps.
  std::optional<Freed> freed(const Pose& q, double clearance);
  /// The same without what is near: cheaper where q is free.
  std::optional<Pose> freedPose(const Pose& q, double clearance);

  /// Of all its queries.
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
  std::vector<std::unique_ptr<CollisionQuery>> eroded_;  ///< per depth; null until it is needed
};

}  // namespace glissade
