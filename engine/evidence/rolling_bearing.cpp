#include "engine/evidence/rolling_bearing.h"

#include <cmath>

namespace glissade::evidence {
namespace {

constexpr double kSphereShare = 0.02;
constexpr std::size_t kFewestBalls = 3;
constexpr std::size_t kFewestRollers = 5;
/// Largest distance of the rings' middles along the axis, in lengths of the outer ring.
constexpr double kSameMiddle = 0.3;
constexpr double kSameAxisApart = 0.05;  ///< in radii
constexpr double kSameDirectionSine = 0.02;
constexpr double kSlack = 1.01;

bool areCoaxial(const BearingRing& one, const BearingRing& other, double radius) {
  return one.axis.cross(other.axis).norm() < kSameDirectionSine &&
         (other.point - one.point).cross(one.axis).norm() < kSameAxisApart * radius;
}

double distanceToAxis(const Vector3& p, const BearingRing& ring) { return (p - ring.point).cross(ring.axis).norm(); }

/// Distance along the axis of the inner ring from the middle of the outer ring.
double besideOuter(const Vector3& p, const BearingRing& inner, const BearingRing& outer) {
  return std::abs((p - outer.middle()).dot(inner.axis));
}

}  // namespace

std::optional<Vector3> ballMiddle(const TriangleMesh& mesh) {
  const Box3 box = boundingBox(mesh);
  const double radius = 0.5 * box.sizes().maxCoeff();
  if (box.sizes().minCoeff() < 2.0 * radius * (1.0 - kSphereShare)) return std::nullopt;
  for (const Vector3& vertex : mesh.vertices) {
    if (std::abs((vertex - box.center()).norm() - radius) > kSphereShare * radius) return std::nullopt;
  }
  return box.center();
}

bool areRaces(const BearingRing& inner, const BearingRing& outer) {
  if (!(inner.outer < outer.outer && inner.hole < outer.hole)) return false;
  return areCoaxial(inner, outer, outer.outer) &&
         besideOuter(inner.middle(), inner, outer) < kSameMiddle * outer.length();
}

bool isBetween(const RollingElement& element, const BearingRing& inner, const BearingRing& outer) {
  const double radius = distanceToAxis(element.middle, inner);
  return radius > inner.hole && radius < outer.outer &&
         besideOuter(element.middle, inner, outer) < 0.5 * outer.length();
}

bool isCageOf(const BearingRing& ring, const BearingRing& inner, const BearingRing& outer) {
  return ring.hole > inner.hole && ring.outer <= kSlack * outer.outer && ring.length() <= kSlack * outer.length() &&
         areCoaxial(inner, ring, outer.outer) && besideOuter(ring.middle(), inner, outer) <= 0.5 * outer.length();
}

bool areOfBearing(std::size_t balls, std::size_t rollers) { return balls >= kFewestBalls || rollers >= kFewestRollers; }

}  // namespace glissade::evidence
