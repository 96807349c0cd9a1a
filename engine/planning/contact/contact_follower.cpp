#include "engine/planning/contact/contact_follower.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glissade {
namespace {

/// Depth by which each step presses the object against its plane, as a share of the step's length.
constexpr double kPress = 0.5;
/// Number of steps of a leg, and its limit of distance queries.
constexpr int kSteps = 6;
constexpr int kMostQueries = 30;
/// A blocked step is tried again with its length multiplied by this factor, down to the shortest length. The distance
/// queried there gives the plane of the obstacle.
constexpr double kShorter = 0.25;
constexpr double kShortest = 1.0 / 1024.0;
/// Distance up to which a learnt plane holds, in radii of the object.
constexpr double kMemory = 1.0;
/// Translation that counts as much as a turn of one radian, in radii of the object. The object turns easily.
constexpr double kTurning = 0.4;
/// Shares of the legs that begin at the hand, and of the legs that keep the orientation.
constexpr double kFromHand = 0.5;
constexpr double kKeepingOrientation = 0.5;
/// A plane differs from another if the angle between their normals is more than 15 degrees (cosine).
constexpr double kSamePlane = 0.966;
/// An obstacle that comes nearer than this share of the gap blocks the step. The object is moved off by the rest of the
/// gap, so that it keeps half of the gap to all other obstacles.
constexpr double kLeastGap = 0.75;

}  // namespace

ContactFollower::ContactFollower(double objectRadius, std::uint64_t seed)
    : radius_(objectRadius), stream_(seed, "contact follower"), plane_(seed), planes_({}) {}

void ContactFollower::enter(const OperatorSample& operatorSample, double gap, double longest) {
  const Vector3 device = operatorSample.q_device.position;
  const Vector3 gone = device - device_.value_or(device);
  device_ = device;
  way_ = gone.norm() > gap ? Vector3(gone.normalized()) : Vector3(Vector3::Zero());
  gap_ = gap;
  hand_ = pressed(operatorSample.q_device, operatorSample.nearest);
  longest_ = longest;
  returns_ = true;
  drawn_ = 0;
  plane_.enter(operatorSample, gap, longest);
}

/// Moves the object along the normal until it keeps the gap.
ContactFollower::Place ContactFollower::pressed(const Pose& q, const NearestObstacle& nearest) const {
  Place place{q, nearest};
  const Vector3 way = (gap_ - nearest.distance) * nearest.normal_W();
  place.q.position += way;
  place.nearest.p_WPn += way;
  place.nearest.distance = gap_;
  return place;
}

Pose ContactFollower::sample(CollisionQuery& query) { return drawn_++ % 2 == 0 ? leg(query) : plane_.sample(); }

Pose ContactFollower::leg(CollisionQuery& query) {
  const bool first = drawn_ == 1;
  if (returns_ || stream_.uniform() < kFromHand) at_ = hand_;
  const bool turns = first || stream_.uniform() >= kKeepingOrientation;
  const std::optional<double> turning = turns ? std::optional(kTurning * radius_) : std::nullopt;
  planes_ = ContactPlanes({radius_, gap_, kMemory * radius_, turning});
  planes_.learn(at_.q, at_.nearest);
  const Pose from = at_.q;
  const Vector3 pressedOn = at_.nearest.normal_W();
  if (way_.isZero()) way_ = nextDirection(pressedOn);
  const double length = longest_ * std::sqrt(stream_.uniform());
  double left = 1.0;
  queries_ = 0;
  while (left > 0.0 && queries_ < kMostQueries) {
    const double made = step(std::min(left, 1.0 / kSteps) * length, query);
    left -= made / length;
    if (made <= 0.0 || at_.nearest.normal_W().dot(pressedOn) < kSamePlane) break;
  }
  returns_ = longestWay(from, at_.q, radius_) < 0.1 * length;
  way_.setZero();
  return at_.q;
}

/// Draws a direction uniformly in the plane.
Vector3 ContactFollower::nextDirection(const Vector3& normal_W) {
  const double height = 2.0 * stream_.uniform() - 1.0;
  const double angle = 2.0 * std::numbers::pi * stream_.uniform();
  const double width = std::sqrt(1.0 - height * height);
  const Vector3 any(width * std::cos(angle), width * std::sin(angle), height);
  const Vector3 along = any - any.dot(normal_W) * normal_W;
  return along.norm() > 1e-3 ? Vector3(along.normalized()) : any;
}

/// One step of the leg, retracted to the gap, until an obstacle blocks it. Returns the length that was made.
double ContactFollower::step(double length, CollisionQuery& query) {
  planes_.forgetFarFrom(at_.q);
  const Vector3 press = kPress * at_.nearest.normal_W();
  const SmallMotion motion = planes_.along(at_.q, {length * (way_ - press), Vector3::Zero()});
  for (double share = 1.0; share >= kShortest; share *= kShorter) {
    const Pose q = moved(at_.q, {share * motion.translation, share * motion.rotation});
    const NearestObstacle nearest = query.nearestObstacle(q);
    ++queries_;
    if (nearest.body < 0 || nearest.distance < kLeastGap * gap_) continue;
    planes_.learn(q, nearest);
    // No point comes nearer to an obstacle by more than it is moved.
    at_ = pressed(q, nearest);
    return share * length;
  }
  return 0.0;
}

}  // namespace glissade
