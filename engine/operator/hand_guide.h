#pragma once

#include "engine/operator/guidance.h"

namespace glissade {

/// Leads a hand along a way, from one target to the next. A target stays until the hand has reached it, cannot go
/// straight to it any more, or is led elsewhere by more than the distance of targets. So a person is not asked for
/// another motion at each moment.
class HandGuide {
 public:
  /// `ahead`: see reachableAhead().
  HandGuide(std::vector<Pose> way, const Se3Metric& metric, double ahead)
      : way_(std::move(way)), metric_(metric), ahead_(ahead) {}

  /// The target of a hand at q; nothing: there is none in sight. For the queries, see reachableAhead().
  std::optional<Pose> lead(const Pose& q, CollisionQuery& sight, CollisionQuery& object);

 private:
  bool isKept(const Pose& q, const std::optional<Pose>& found, CollisionQuery& object) const;

  std::vector<Pose> way_;
  Se3Metric metric_;
  double ahead_;
  std::optional<Pose> target_;
};

}  // namespace glissade
