#include "engine/operator/reachable_ahead.h"

#include <array>

#include "engine/base/tolerances.h"

namespace glissade {
namespace {

/// The distances that are tried, in shares of `ahead`. A person does not move and turn in step, so that farther ones
/// would lead them off the way.
constexpr std::array<double, 5> kDistances{1.0, 0.5, 0.25, 0.125, 0.0625};
/// Least turn and move that are led apart from each other, radians and radii of the object.
constexpr double kApart = 0.02;
/// Clearance of a free motion, in contact gaps. A hand in contact keeps about one.
constexpr double kFreeGap = 0.1;

/// The pose to which the object goes first on a free motion to another pose; nothing: none was found.
std::optional<Pose> firstOf(const Pose& from, const Pose& to, double radius, CollisionQuery& object) {
  const auto isFree = [&object, radius](const Pose& a, const Pose& b) { return isFreeMotion(a, b, radius, object); };
  if (isFree(from, to)) return to;
  const double turn = angleBetween(from.orientation, to.orientation);
  const double move = (to.position - from.position).norm();
  if (turn < kApart || move < kApart * radius) return std::nullopt;
  for (const Pose& corner : {Pose{from.position, to.orientation}, Pose{to.position, from.orientation}}) {
    if (isFree(from, corner) && isFree(corner, to)) return corner;
  }
  return std::nullopt;
}

}  // namespace

bool isFreeMotion(const Pose& from, const Pose& to, double objectRadius, CollisionQuery& object) {
  const double clear = kFreeGap * tolerance::kContactGap * objectRadius;
  return object.checkMotion(from, to, clear, SeekViolation::Any, {}).status == CertificateStatus::Certified;
}

std::optional<Pose> reachableAhead(const std::vector<Pose>& way, const Pose& q, const Se3Metric& metric, double ahead,
                                   CollisionQuery& sight, CollisionQuery& object) {
  for (const double share : kDistances) {
    const auto target = aheadInSight(way, q, metric, share * ahead, sight);
    if (!target) return std::nullopt;
    if (const auto first = firstOf(q, *target, metric.radius(), object)) return first;
  }
  return aheadInSight(way, q, metric, ahead, sight);
}

}  // namespace glissade
