#pragma once

#include "engine/geometry/se3_metric.h"
#include "engine/sequence/step_way.h"

namespace glissade {

/// A part that a hand leads back along the motion of its step to its assembled pose. It stays on this motion, which is
/// certified, and follows the hand along it. Near its end it snaps to its assembled pose, and stays there.
class LedPart {
 public:
  /// Share of the motion from its end at which the part snaps.
  static constexpr double kSnaps = 0.03;

  /// `X_WB`: assembled pose of the first body of the step. The part begins at the other end of the motion.
  LedPart(StepWay way, const Pose& X_WB);

  /// The hand holds the part at `X_WB`: the part moves to the nearest pose that it can slide to.
  void lead(const Pose& X_WB);
  /// Pose of the part.
  Pose X_WB() const { return at(share_); }
  /// Share of the motion between the part and its assembled pose: 1 at the start, 0 once it has snapped.
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
