#pragma once

#include "widgets/scene3d/scene_pick.h"

namespace glissade {

/// A drag of a body: it moves in the plane of the view through the gripped point, or turns about the view's axes. It is
/// plain geometry.
class PoseDrag {
 public:
  /// `grip_W` is the gripped point, `R_WV` the orientation of the view.
  PoseDrag(const Pose& X_WB, const Vector3& grip_W, const Quaternion& R_WV) : X_WB_(X_WB), grip_(grip_W), R_WV_(R_WV) {}

  const Pose& pose() const { return X_WB_; }

  /// Follows the pointer.
  void moveTo(const Ray& ray);
  /// Turns by a motion (dx, dy) of the pointer, in fractions of the view's height, y down: half a turn for each height.
  void turn(double dx, double dy);

 private:
  Pose X_WB_;
  Vector3 grip_;
  Quaternion R_WV_;
};

}  // namespace glissade
