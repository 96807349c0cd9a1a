#pragma once

#include "engine/planning/problem.h"
#include "engine/planning/screw_motion.h"

namespace glissade {

/// The screw motions with which a path begins and ends.
class ScrewWays {
 public:
  virtual ~ScrewWays() = default;

  /// Out of the threads that the object is in there.
  virtual ScrewSearch out(CollisionQuery& query, const Pose& from, double required, const StopToken& stop) const = 0;
  /// From one configuration in a thread to another one in the same; empty where none leads there or it is not free.
  virtual std::vector<Pose> between(CollisionQuery& query, const Pose& from, const Pose& to, double required,
                                    const StopToken& stop) const = 0;
};

/// Of threads that a person has marked (ThreadPair).
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
