#pragma once

#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/step_way.h"

namespace glissade {

/// The state of a body while a plan is played.
struct PlayedBody {
  Pose moved;          ///< displacement: the body is at moved * X_WB, where X_WB is its assembled pose
  bool left = false;   ///< its step is over: it is at the end of its motion
  bool moves = false;  ///< it moves in the present step
};

/// A plan as one motion of the whole product: every step takes one unit of time. A value.
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
  struct Step {
    std::vector<std::size_t> bodies;
    StepWay way;
  };

  std::size_t bodies_ = 0;
  std::vector<Step> steps_;
};

}  // namespace glissade
