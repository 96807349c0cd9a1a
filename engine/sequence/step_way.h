#pragma once

#include <vector>

#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/body_group.h"

namespace glissade {

/// A motion at constant speed in the metric of its first body. A value.
class StepWay {
 public:
  StepWay(const StepMotion& motion, const RigidBody& firstBody);

  /// Length in the metric of the first body, metres.
  double length() const { return arrival_.empty() ? 0.0 : arrival_.back(); }
  /// The radius of the metric, metres.
  double radius() const { return radius_; }
  /// Displacement after this length, from 0 to length(): a body of the motion is at movedAt(way) * X_WB, where X_WB is
  /// its assembled pose.
  Pose movedAt(double way) const;

 private:
  double radius_;
  std::vector<Pose> way_;
  std::vector<double> arrival_;  ///< length from the start to each configuration
};

}  // namespace glissade
