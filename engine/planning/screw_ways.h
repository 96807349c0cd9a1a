#pragma once

#include "engine/planning/problem.h"
#include "engine/planning/screw_motion.h"

namespace glissade {

/// Finds the screw motions at the beginning and the end of a path.
class ScrewWays {
 public:
  virtual ~ScrewWays() = default;

  /// Screw motions out of the threads in which the object is at `from`.
  virtual ScrewSearch out(CollisionQuery& query, const Pose& from, double required, const StopToken& stop) const = 0;
  /// The screw motion from one configuration in a thread to another one in the same thread; empty where there is none
  /// or it is not free.
  virtual std::vector<Pose> between(CollisionQuery& query, const Pose& from, const Pose& to, double required,
                                    const StopToken& stop) const = 0;
};

/// Screw motions of the threads that a person has marked (ThreadPair).
class MarkedThreadWays final : public ScrewWays {
 public:
  explicit MarkedThreadWays(CollisionWorldPtr world) : world_(std::move(world)) {}

  ScrewSearch out(CollisionQuery& query, const Pose& from, double required, const StopToken& stop) const override {
    return findScrewWays(*world_, query, from, required, stop);
  }
  std::vector<Pose> between(CollisionQuery& query, const Pose& from, const Pose& to, double required,
                            const StopToken& stop) const override {
    return screwBetween(*world_, query, from, to, required, stop);
  }

 private:
  CollisionWorldPtr world_;
};

}  // namespace glissade
