#pragma once

#include <memory>
#include <vector>

#include "engine/fits/modelled_thread.h"
#include "engine/planning/screw_ways.h"

namespace glissade {

/// The threads that the object is in at this configuration: surfaces of object and obstacle that are near each other
/// and that the same screw motion moves along themselves. Each thread is listed with three axes: the obstacle's, the
/// object's, and their middle. The axes differ by the play. Takes milliseconds where nothing is near.
std::vector<ModelledThread> findModelledThreads(const CollisionWorld& world, const Pose& at);

/// Finds screw motions out of modelled threads. Each is proved as one motion.
class ModelledThreadWays final : public ScrewWays {
 public:
  explicit ModelledThreadWays(CollisionWorldPtr world) : world_(std::move(world)) {}

  ScrewSearch out(CollisionQuery& query, const Pose& from, double required, const StopToken& stop) const override;
  std::vector<Pose> between(CollisionQuery& query, const Pose& from, const Pose& to, double required,
                            const StopToken& stop) const override;

 private:
  CollisionWorldPtr world_;
};

}  // namespace glissade
