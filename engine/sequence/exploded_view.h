#pragma once

#include "engine/sequence/step_way.h"

namespace glissade {

/// A product that is moved apart. The bodies go in the order of the plan, one step after the other, each on the path of
/// its step and, where that ends too near, straight on. A body stops as soon as its bounding box is clear of all bodies
/// that have not moved, and of the ways of those that move later. So no body moves through another one, as far as the
/// plan is proved; of the straight ends nothing is proved but that bounding boxes are clear. A value.
class ExplodedView {
 public:
  ExplodedView() = default;
  /// Precondition: the plan is about this product.
  ExplodedView(const AssembledProduct& product, const AssemblyPlan& plan);

  /// How the bodies have moved at this share of the whole, in [0, 1]: each stands at its pose times X_WB, where X_WB is
  /// the assembled configuration. Bodies that the plan does not remove stay.
  std::vector<Pose> at(double share) const;

 private:
  struct Step {
    std::vector<std::size_t> bodies;
    StepWay way;
    double along = 0.0;                ///< on the path, as StepWay counts
    Vector3 beyond = Vector3::Zero();  ///< after that, metres

    double length() const { return along + beyond.norm(); }
    Pose movedAt(double way) const;
  };
  class Placement;

  std::size_t bodies_ = 0;
  std::vector<Step> steps_;  ///< in the order of the plan
};

}  // namespace glissade
