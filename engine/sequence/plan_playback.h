#pragma once

#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/step_way.h"

namespace glissade {

/// The state of a body while a plan is played.
struct PlayedBody {
  Pose moved;          ///< displacement: the body is at moved * X_WB, where X_WB is its assembled pose
  bool left = false;   ///< its motion is over
  bool moves = false;  ///< it moves now
};

/// A motion of a plan that is in progress.
struct PlayedMotion {
  std::size_t step = 0;    ///< index
  std::size_t motion = 0;  ///< index in the step, which it takes an equal share of
  double share = 0.0;      ///< done share of the motion

  /// The time of PlanPlayback at which the motion is there.
  double time(const AssemblyPlan& plan) const;
};

/// The motion in progress at this time. Precondition: `time` is in [0, number of steps).
PlayedMotion playedMotionAt(double time, const AssemblyPlan& plan);

/// A plan as one motion of the whole product: every step takes one unit of time, in equal shares of its motions. A
/// value.
class PlanPlayback {
 public:
  PlanPlayback() = default;
  /// Precondition: the plan belongs to this product.
  PlanPlayback(const AssembledProduct& product, const AssemblyPlan& plan);

  /// Number of steps of the plan.
  std::size_t steps() const { return steps_.size(); }
  /// The state of all bodies after `time` steps, from 0 to steps(). Between two whole numbers the step between them is
  /// in progress, at constant speed in the metric of its body.
  std::vector<PlayedBody> at(double time) const;

 private:
  struct Motion {
    std::vector<std::size_t> bodies;
    StepWay way;
  };

  std::size_t bodies_ = 0;
  std::vector<std::vector<Motion>> steps_;
};

}  // namespace glissade
