#include "engine/operator/hand_guide.h"

#include "engine/operator/reachable_ahead.h"

namespace glissade {
namespace {

/// Distance at which a target counts as reached, as a share of the distance of targets.
constexpr double kTargetReached = 0.1;

}  // namespace

std::optional<Pose> HandGuide::lead(const Pose& q, CollisionQuery& sight, CollisionQuery& object) {
  const auto found = reachableAhead(way_, q, metric_, ahead_, sight, object);
  if (!isKept(q, found, object)) target_ = found;
  return target_;
}

bool HandGuide::isKept(const Pose& q, const std::optional<Pose>& found, CollisionQuery& object) const {
  if (!target_ || metric_.distance(q, *target_) < kTargetReached * ahead_) return false;
  if (found && metric_.distance(*found, *target_) > ahead_) return false;
  return isFreeMotion(q, *target_, metric_.radius(), object);
}

}  // namespace glissade
