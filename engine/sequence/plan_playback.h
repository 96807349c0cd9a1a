#pragma once

#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/step_way.h"

namespace glissade {

/// Where a body is while a plan is played.
struct PlayedBody {
  Pose moved;          ///< it stands at moved * X_WB, where X_WB is the assembled configuration
  bool left = false;   ///< its step is over: it is where its motion ends
  bool moves = false;  ///< in the step that is under way
};

/// A plan as one motion of the whole product: every step takes one unit of time. A value.
class PlanPlayback {
 public:
  PlanPlayback() = default;
  /// Precondition: the plan is about this product.
  PlanPlayback(const AssembledProduct& product, const AssemblyPlan& plan);

  /// Of the plan.
  std::size_t steps() const { return steps_.size(); }
  /// All bodies after so many steps, from 0 to steps(). Between two whole numbers the step between them is under way,
  /// at constant speed in the metric of its body.
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
