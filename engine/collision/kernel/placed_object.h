#pragma once

#include <cstdint>
#include <vector>

#include "engine/collision/kernel/box_tree.h"
#include "engine/collision/motion_bound.h"

namespace glissade {

/// The object's tree at one pose, in the frame of the obstacles' tree. Boxes are placed when they are
/// first asked for and kept until the next pose. One per thread.
class PlacedObject {
 public:
  PlacedObject(const BoxTree& obstacles, const BoxTree& object, const lanes::LaneFunctions& functions);

  /// Another tree of obstacles. The object has to be moved then.
  void setObstacles(const BoxTree& obstacles) { obstacles_ = &obstacles; }
  void moveTo(const Pose& X_WB);
  /// Besides, lets it go on from there, at that velocity, for time `half` to both sides.
  void sweep(const Velocity& velocity, double half);

  /// Bound on the rounding of any length computed in single precision at this pose, metres.
  float slack() const { return slack_; }
  /// At most the distance between the object and the obstacles: that of spheres around all.
  double sphereGap() const { return sphereGap_; }

  const lanes::BoxLanes& node(std::uint32_t index) {
    if (placedAt_[index] != current_) place(index);
    return placed_[index];
  }
  void leaf(BoxTree::Box box, lanes::TriangleLanes& placed) const;

  /// The sweep of a node's boxes. `sweepSlack` bounds the rounding of the sweep, as `slack` bounds that of a pose.
  const lanes::SweepLanes& sweepOf(std::uint32_t index) const { return sweeps_[index]; }
  float sweepSlack() const { return sweepSlack_; }
  void sweepTriangles(const lanes::TriangleLanes& placed, lanes::TriangleLanes& ways) const;
  /// In the world frame, as `X_WB * vertex` rounds.
  Triangle triangle(std::uint32_t index) const;

 private:
  void place(std::uint32_t index);

  const BoxTree* obstacles_;
  const BoxTree& object_;
  const lanes::LaneFunctions& functions_;
  Pose X_WB_;
  lanes::FloatPose X_{};
  float slack_ = 0.0F;
  double sphereGap_ = 0.0;
  bool swept_ = false;
  lanes::FloatSweep sweep_{};
  float sweepSlack_ = 0.0F;
  std::uint32_t current_ = 0;
  std::vector<std::uint32_t> placedAt_;  ///< `current_` when the node was placed
  std::vector<lanes::BoxLanes> placed_;
  std::vector<lanes::SweepLanes> sweeps_;  ///< of placed nodes; as many as there are once it is swept
};

}  // namespace glissade
