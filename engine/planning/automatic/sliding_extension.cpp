#include "engine/planning/automatic/sliding_extension.h"

#include "engine/collision/motion_certificate.h"

namespace glissade {
namespace {

/// Most planes that one extension learns.
constexpr int kMostLearnt = 3;
/// Number of times that a blocked motion is halved before the distance is queried.
constexpr int kHalvings = 3;
/// Smallest progress of an extension, as a share of the intended motion.
constexpr double kLeast = 0.2;
/// Gap kept at contacts, in radii of the object. Twice the gap of contact samples needs fewer distance queries.
constexpr double kGap = 2e-3;
/// Planes that were learnt farther away than this are forgotten, in multiples of the range.
constexpr double kMemory = 10.0;

}  // namespace

SlidingExtension::SlidingExtension(CollisionQuery& query, const Box3& bounds, const Se3Metric& metric, double range)
    : query_(query),
      bounds_(bounds),
      metric_(metric),
      rule_{query.motionBound().objectRadius(), kGap * query.motionBound().objectRadius(), kMemory * range,
            metric.radius()} {}

std::optional<Pose> SlidingExtension::slide(Node from, const Pose& q, const Pose& target, double step,
                                            const StopToken& stop) {
  const SmallMotion wanted{target.position - q.position, rotationVector(q.orientation, target.orientation)};
  const double least = kLeast * metric_.distance(q, target);
  ContactPlanes planes = planesOf(from) ? *planesOf(from) : ContactPlanes(rule_);
  planes.forgetFarFrom(q);
  Pose blocked = target;
  int learnt = 0;
  std::optional<Pose> end;
  for (bool known = !planes.empty();; known = true) {
    if (known) {
      blocked = moved(q, planes.along(q, wanted));
      if (metric_.distance(q, blocked) < least || !bounds_.contains(blocked.position)) break;
      if (freeFraction(query_, q, blocked, step, stop) >= 1.0) end = blocked;
    }
    if (end || learnt == kMostLearnt || stop.stopRequested() || !learn(planes, q, blocked)) break;
    ++learnt;
  }
  if (learnt > 0) planesOf(from) = std::make_shared<const ContactPlanes>(std::move(planes));
  return end;
}

/// Learns the plane of the nearest obstacle shortly before the motion is blocked.
bool SlidingExtension::learn(ContactPlanes& planes, const Pose& q, const Pose& blocked) {
  double free = 0.0;
  double end = 1.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (free + end);
    (query_.collides(interpolate(q, blocked, middle)) ? end : free) = middle;
  }
  const Pose before = interpolate(q, blocked, free);
  const NearestObstacle nearest = query_.nearestObstacle(before);
  if (nearest.body < 0 || nearest.distance <= 0.0) return false;
  planes.learn(before, nearest);
  return true;
}

void SlidingExtension::keep(Node from, Node child) { planesOf(child) = Planes(planesOf(from)); }

SlidingExtension::Planes& SlidingExtension::planesOf(Node node) {
  if (node >= planes_.size()) planes_.resize(node + 1);
  return planes_[node];
}

}  // namespace glissade
