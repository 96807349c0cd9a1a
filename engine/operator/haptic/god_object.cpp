#include "engine/operator/haptic/god_object.h"

#include <algorithm>

#include "engine/base/tolerances.h"

namespace glissade {
namespace {

/// Share of the gap of contact samples that is kept at contact; the other part is for further motion.
constexpr double kKept = 0.5;
/// Longest step along contacts, in gaps. The sweeps leave a small share of it, which must be small against the gap.
constexpr double kLongestStep = 20.0;

/// Distance beyond which learnt contacts do not count any more, in radii of the object.
constexpr double kContactMemory = 0.03;

}  // namespace

GodObject::GodObject(double objectRadius)
    : radius_(objectRadius),
      contacts_({objectRadius, tolerance::kContactGap * objectRadius, kContactMemory * objectRadius, objectRadius}) {}

void GodObject::place(const Pose& q) {
  q_ = q;
  known_ = false;
  contacts_.clear();
}

void GodObject::learn(const Surroundings& surroundings) {
  if (known_ ? surroundings.q == surroundings_.q : surroundings.q != q_) return;
  surroundings_ = surroundings;
  known_ = true;
  contacts_.learn(surroundings.q, surroundings.nearest);
}

SmallMotion GodObject::stepTo(const Pose& X_WD) const {
  const double longest = kLongestStep * tolerance::kContactGap * radius_;
  const double share = std::min(1.0, longest / std::max(longest, longestWay(q_, X_WD, radius_)));
  return {share * (X_WD.position - q_.position), share * rotationVector(q_.orientation, X_WD.orientation)};
}

const Pose& GodObject::follow(const Pose& X_WD) {
  if (!known_) return q_;
  if (surroundings_.clearance <= 0.0) return q_ = X_WD;
  contacts_.forgetFarFrom(q_);
  const Pose target = contacts_.empty() ? X_WD : moved(q_, contacts_.along(q_, stepTo(X_WD)));
  // The ball is convex, so that a straight motion between two configurations in it is free.
  const double clearance = surroundings_.clearance;
  const double ball = clearance - kKept * std::min(tolerance::kContactGap * radius_, clearance);
  const double left = ball - longestWay(surroundings_.q, q_, radius_);
  const double length = longestWay(q_, target, radius_);
  if (length <= 0.0 || left <= 0.0) return q_;
  return q_ = length <= left ? target : interpolate(q_, target, left / length);
}

NearestObstacle GodObject::nearest() const {
  NearestObstacle moved = surroundings_.nearest;
  if (!known_ || moved.body < 0 || moved.distance <= 0.0) return moved;
  const Vector3 normal_W = moved.normal_W();
  const Vector3 p_WPn = q_ * (inverse(surroundings_.q) * moved.p_WPn);
  moved.distance = std::max(normal_W.dot(p_WPn - moved.p_WPo), kKept * tolerance::kContactGap * radius_);
  moved.p_WPn = p_WPn;
  moved.p_WPo = p_WPn - moved.distance * normal_W;
  return moved;
}

}  // namespace glissade
