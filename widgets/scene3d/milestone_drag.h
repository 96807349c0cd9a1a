#pragma once

#include <optional>

#include "engine/planning/coarse/coarse_plan.h"
#include "widgets/scene3d/scene_pick.h"

namespace glissade {

/// A milestone of the coarse plan in the pointer's grip: it moves in the plane of the view through the
/// point that was gripped, or turns about the view's axes. Plain geometry.
class MilestoneDrag {
 public:
  /// Grips the nearest milestone along the ray, up to `farthest`; nothing where there is none.
  /// `R_WV` is the orientation of the view.
  static std::optional<MilestoneDrag> grip(const CoarsePlan& plan, const MeshPtr& object, const Ray& ray,
                                           double farthest, const Quaternion& R_WV);

  /// Index of the topological step whose milestone it is.
  std::size_t step() const { return step_; }
  const Pose& pose() const { return pose_; }

  /// Follows the pointer inside the region; beyond it, the milestone stays where it was last.
  void moveTo(const Ray& ray, const SamplingRegion& region);
  /// The pointer went by (dx, dy), in fractions of the view's height, y down: half a turn a height.
  void turn(double dx, double dy);

 private:
  std::size_t step_ = 0;
  Pose pose_;
  Vector3 p_WO_ = Vector3::Zero();  ///< where the object's reference point would be, were there no bounds
  Vector3 grip_ = Vector3::Zero();  ///< the point that was gripped, world
  Quaternion R_WV_ = Quaternion::Identity();
};

}  // namespace glissade
