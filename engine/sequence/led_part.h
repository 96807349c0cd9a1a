#pragma once

#include "engine/geometry/se3_metric.h"
#include "engine/sequence/step_way.h"

namespace glissade {

/// A part that a hand leads along the motion of its step, back to where it is assembled. It stays on this motion, which
/// is certified, and goes as far along it as the hand does. Near its end it snaps to where it belongs, and stays there.
class LedPart {
 public:
  /// The part is this share of the motion or less from its end where it snaps.
  static constexpr double kSnaps = 0.03;

  /// X_WB: of the first body of the step, assembled. The part is at the other end of the motion.
  LedPart(StepWay way, const Pose& X_WB);

  /// The hand has the part here: the part goes to the place nearest to it that it can slide to.
  void lead(const Pose& X_WB);
  /// Where the part is.
  Pose X_WB() const { return at(share_); }
  /// Of its motion, from where it is assembled: 0 once it has snapped, 1 at first.
  double share() const { return share_; }
  bool isAssembled() const { return share_ == 0.0; }

 private:
  Pose at(double share) const;

  StepWay way_;
  Pose assembled_;
  Se3Metric metric_;
  double share_ = 1.0;
};

}  // namespace glissade
