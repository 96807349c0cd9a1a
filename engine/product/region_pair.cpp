#include "engine/product/region_pair.h"

#include <algorithm>
#include <cmath>

#include "engine/geometry/triangle_pair.h"

namespace glissade {
namespace {

using Kind = SurfaceRegions::Kind;

/// Sine of the angle between directions that count as parallel.
constexpr double kParallel = 1e-4;
/// Length along the axis that a shaft and its hole have in common at least, metres.
constexpr double kLeastLength = 1e-5;
/// Axes may be this far apart, metres.
constexpr double kSameAxis = 3e-6;

bool areParallel(const Vector3& a, const Vector3& b) { return a.cross(b).squaredNorm() < kParallel * kParallel; }

std::optional<RegionPair> comparePlanes(const PlaneRegion& a, const PlaneRegion& b) {
  if (!areParallel(a.normal, b.normal) || a.normal.dot(b.normal) > 0.0) return std::nullopt;
  return RegionPair{RegionPair::Kind::Planes, -b.offset - a.offset, {}};
}

/// Point of the axis in the middle of the cylinder.
Vector3 middleOf(const CylinderRegion& c) { return c.point + 0.5 * (c.low + c.high) * c.direction; }

double distanceFromAxis(const CylinderRegion& c, const Vector3& p) { return (p - c.point).cross(c.direction).norm(); }

/// Not one behind the other.
bool besideEachOther(const CylinderRegion& a, const CylinderRegion& b) {
  const double middle = (middleOf(b) - middleOf(a)).dot(a.direction);
  return std::abs(middle) <= 0.5 * (a.high - a.low + b.high - b.low) - kLeastLength;
}

std::optional<RegionPair> compareCylinders(const CylinderRegion& a, const CylinderRegion& b) {
  if (!areParallel(a.direction, b.direction) || !besideEachOther(a, b)) return std::nullopt;
  const double apart = std::max(distanceFromAxis(a, middleOf(b)), distanceFromAxis(b, middleOf(a)));
  if (a.shaft != b.shaft && apart < kSameAxis) {
    RegionPair pair{RegionPair::Kind::Coaxial, a.shaft ? b.radius - a.radius : a.radius - b.radius, {}};
    const double from = std::max(a.low, (middleOf(b) - a.point).dot(a.direction) - 0.5 * (b.high - b.low));
    const double to = std::min(a.high, (middleOf(b) - a.point).dot(a.direction) + 0.5 * (b.high - b.low));
    pair.axis = {a.point + 0.5 * (from + to) * a.direction, a.direction, a.radius, b.radius, a.shaft};
    return pair;
  }
  if (a.shaft && b.shaft) return RegionPair{RegionPair::Kind::Tangent, apart - a.radius - b.radius, {}};
  return std::nullopt;
}

std::optional<RegionPair> compareMixed(const CylinderRegion& cylinder, const PlaneRegion& plane) {
  if (!cylinder.shaft || std::abs(cylinder.direction.dot(plane.normal)) > kParallel) return std::nullopt;
  const double height = plane.normal.dot(middleOf(cylinder)) - plane.offset;
  return RegionPair{RegionPair::Kind::Tangent, height - cylinder.radius, {}};
}

}  // namespace

std::optional<RegionPair> compareRegions(const SurfaceRegions& a, const SurfaceRegions::Label& labelA,
                                         const SurfaceRegions& b, const SurfaceRegions::Label& labelB) {
  if (labelA.kind == Kind::Free || labelB.kind == Kind::Free) return std::nullopt;
  if (labelA.kind == Kind::Plane && labelB.kind == Kind::Plane) {
    return comparePlanes(a.planes[labelA.index], b.planes[labelB.index]);
  }
  if (labelA.kind == Kind::Cylinder && labelB.kind == Kind::Cylinder) {
    return compareCylinders(a.cylinders[labelA.index], b.cylinders[labelB.index]);
  }
  return labelA.kind == Kind::Cylinder ? compareMixed(a.cylinders[labelA.index], b.planes[labelB.index])
                                       : compareMixed(b.cylinders[labelB.index], a.planes[labelA.index]);
}

bool overlapInPlane(const Triangle& a, const Triangle& b, const PlaneRegion& plane) {
  const Vector3 u = plane.normal.unitOrthogonal();
  const Vector3 v = plane.normal.cross(u);
  const auto flat = [&](const Triangle& triangle) {
    Triangle result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = {triangle[i].dot(u), triangle[i].dot(v), 0.0};
    return result;
  };
  return trianglesMeet(flat(a), flat(b));
}

}  // namespace glissade
