#pragma once

#include <optional>

#include "engine/planning/coarse/coarse_plan.h"
#include "widgets/scene3d/pose_drag.h"
#include "widgets/scene3d/scene_pick.h"

namespace glissade {

/// A drag of a milestone of the coarse plan, kept inside a region. It is plain geometry.
class MilestoneDrag {
 public:
  /// Grips the nearest milestone along the ray, up to `farthest`; nothing if there is none. `R_WV` is the orientation
  /// of the view.
  static std::optional<MilestoneDrag> grip(const CoarsePlan& plan, const MeshPtr& object, const Ray& ray,
                                           double farthest, const Quaternion& R_WV);

  /// Index of the topological step whose milestone it is.
  std::size_t step() const { return step_; }
  const Pose& pose() const { return pose_; }

  /// Follows the pointer inside the region; beyond it, the milestone stays at its last place.
  void moveTo(const Ray& ray, const SamplingRegion& region);
  /// Turns the milestone as PoseDrag::turn() does.
  void turn(double dx, double dy);

 private:
  MilestoneDrag(std::size_t step, const PoseDrag& drag) : step_(step), drag_(drag), pose_(drag.pose()) {}

  std::size_t step_;
  PoseDrag drag_;  ///< the drag without a region
  Pose pose_;
};

}  // namespace glissade
