#include "engine/operator/guidance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/geometry/primitives.h"

namespace glissade {
namespace {

/// Distance at which the spring of attraction has half its strength, in radii of the object.
constexpr double kAttractionReach = 0.3;

/// Size of an object that is nearly a point, in radii of the object that it stands for.
constexpr double kPoint = 1e-4;
/// Number of nearer points that are tried for a point that is out of sight.
constexpr int kNearer = 8;

Vector3 shortened(const Vector3& v) {
  const double length = v.norm();
  return length > 1.0 ? Vector3(v / length) : v;
}

/// Share of the straight motion from a to b at which it is nearest to q, by positions, or by angles where it does not
/// translate.
double nearestShare(const Pose& a, const Pose& b, const Pose& q) {
  const Vector3 way = b.position - a.position;
  if (!way.isZero()) return std::clamp(way.dot(q.position - a.position) / way.squaredNorm(), 0.0, 1.0);
  const double fromA = angleBetween(a.orientation, q.orientation);
  const double fromB = angleBetween(b.orientation, q.orientation);
  return fromA + fromB > 0.0 ? fromA / (fromA + fromB) : 1.0;
}

}  // namespace

Wrench repulsion(const Guidance& guidance, const Pose& X_WB, const NearestObstacle& nearest, double objectRadius) {
  const bool near = nearest.body >= 0 && nearest.distance > 0.0 && nearest.distance < guidance.distance;
  if (!near || guidance.repulsion <= 0.0) return {};
  const double depth = 1.0 - nearest.distance / guidance.distance;
  const Vector3 force_W = guidance.repulsion * depth * depth * nearest.normal_W();
  return {force_W, (nearest.p_WPn - X_WB.position).cross(force_W) / objectRadius};
}

Wrench attraction(const Guidance& guidance, const Pose& X_WB, double objectRadius) {
  if (!guidance.target || guidance.attraction <= 0.0) return {};
  const Vector3 way = (guidance.target->position - X_WB.position) / objectRadius;
  const Vector3 turn = rotationVector(X_WB.orientation, guidance.target->orientation);
  const double stretch = std::sqrt(way.squaredNorm() + turn.squaredNorm() + kAttractionReach * kAttractionReach);
  return {guidance.attraction / stretch * way, guidance.attraction / stretch * turn};
}

Wrench saturated(const Wrench& shares) { return {shortened(shares.force_W), shortened(shares.torque_W)}; }

Wrench guidanceWrench(const Guidance& guidance, const Pose& X_WB, const NearestObstacle& nearest, double objectRadius) {
  return saturated(repulsion(guidance, X_WB, nearest, objectRadius) + attraction(guidance, X_WB, objectRadius));
}

std::optional<Pose> aheadOnWay(const std::vector<Pose>& way, const Pose& q, const Se3Metric& metric, double ahead) {
  if (way.empty()) return std::nullopt;
  std::size_t segment = 0;
  Pose at = way.front();
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    const Pose candidate = interpolate(way[i], way[i + 1], nearestShare(way[i], way[i + 1], q));
    const double distance = metric.distance(candidate, q);
    if (distance > nearest) continue;
    nearest = distance;
    segment = i;
    at = candidate;
  }
  for (std::size_t i = segment + 1; i < way.size(); ++i) {
    const double length = metric.distance(at, way[i]);
    if (length > ahead) return interpolate(at, way[i], ahead / length);
    ahead -= length;
    at = way[i];
  }
  return way.back();
}

CollisionWorldPtr pointWorld(const CollisionWorld& world) {
  const double size = kPoint * world.objectRadius();
  return world.updated(world.obstacles(), std::make_shared<const TriangleMesh>(makeBox(Vector3::Constant(size))));
}

std::optional<Pose> aheadInSight(const std::vector<Pose>& way, const Pose& q, const Se3Metric& metric, double ahead,
                                 CollisionQuery& sight) {
  const Pose eye = Pose::translation(q.position);
  if (sight.collides(eye)) return aheadOnWay(way, q, metric, ahead);
  const auto isSeen = [&](const Pose& there) {
    const Pose to = Pose::translation(there.position);
    return sight.checkMotion(eye, to, kPoint * metric.radius(), SeekViolation::Any, {}).status ==
           CertificateStatus::Certified;
  };
  for (int i = kNearer; i > 0; --i) {
    const auto target = aheadOnWay(way, q, metric, ahead * i / kNearer);
    if (target && isSeen(*target)) return target;
  }
  std::optional<Pose> nearest;
  for (const Pose& there : way) {
    const bool isNearer = !nearest || metric.distance(there, q) < metric.distance(*nearest, q);
    if (isNearer && isSeen(there)) nearest = there;
  }
  return nearest;
}

}  // namespace glissade
