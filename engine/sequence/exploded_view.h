#pragma once

#include "engine/sequence/step_way.h"

namespace glissade {

/// An exploded view of a product. The bodies move in the order of the plan, step after step, each along the path of its
/// step and, if that ends too near, straight on. A body stops as soon as its bounding box is clear of the bodies that
/// have not moved, and of the motions of those that move later. No body therefore moves through another one, as far as
/// the plan is proved. The straight continuations are only checked by bounding boxes. A value.
class ExplodedView {
 public:
  ExplodedView() = default;
  /// Precondition: the plan belongs to this product.
  ExplodedView(const AssembledProduct& product, const AssemblyPlan& plan);

  /// The displacement of each body at this share of the whole motion, in [0, 1]: the body is at displacement * X_WB,
  /// where X_WB is its assembled pose. Bodies that the plan does not remove stay.
  std::vector<Pose> at(double share) const;

 private:
  struct Step {
    std::vector<std::size_t> bodies;
    StepWay way;
    double along = 0.0;                ///< length on the path, as StepWay counts it
    Vector3 beyond = Vector3::Zero();  ///< translation after the path, metres

    double length() const { return along + beyond.norm(); }
    Pose movedAt(double way) const;
  };
  class Placement;

  std::size_t bodies_ = 0;
  std::vector<Step> steps_;  ///< steps in the order of the plan
};

}  // namespace glissade
