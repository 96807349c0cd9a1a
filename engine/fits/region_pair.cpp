#include "engine/fits/region_pair.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/geometry/triangle_pair.h"

namespace glissade {
namespace {

using Kind = SurfaceRegions::Kind;

/// Sine of the angle between directions that count as parallel.
constexpr double kParallel = 1e-4;
/// Least length along the axis that a shaft and its hole share, metres.
constexpr double kLeastLength = 1e-5;
/// Largest distance of coaxial axes, metres.
constexpr double kSameAxis = 3e-6;

bool areParallel(const Vector3& a, const Vector3& b) { return a.cross(b).squaredNorm() < kParallel * kParallel; }

std::optional<RegionPair> comparePlanes(const PlaneRegion& a, const PlaneRegion& b) {
  if (!areParallel(a.normal, b.normal) || a.normal.dot(b.normal) > 0.0) return std::nullopt;
  return RegionPair{RegionPair::Kind::Planes, -b.offset - a.offset};
}

/// The middle of the cylinder on its axis.
Vector3 middleOf(const CylinderRegion& c) { return c.point + 0.5 * (c.low + c.high) * c.direction; }

double distanceFromAxis(const CylinderRegion& c, const Vector3& p) { return (p - c.point).cross(c.direction).norm(); }

/// True if the cylinders overlap along the axis.
bool besideEachOther(const CylinderRegion& a, const CylinderRegion& b) {
  const double middle = (middleOf(b) - middleOf(a)).dot(a.direction);
  return std::abs(middle) <= 0.5 * (a.high - a.low + b.high - b.low) - kLeastLength;
}

std::optional<RegionPair> compareCylinders(const CylinderRegion& a, const CylinderRegion& b) {
  if (!areParallel(a.direction, b.direction) || !besideEachOther(a, b)) return std::nullopt;
  const double apart = std::max(distanceFromAxis(a, middleOf(b)), distanceFromAxis(b, middleOf(a)));
  if (a.shaft != b.shaft && apart < kSameAxis) {
    RegionPair pair{RegionPair::Kind::Coaxial, a.shaft ? b.radius - a.radius : a.radius - b.radius};
    const double from = std::max(a.low, (middleOf(b) - a.point).dot(a.direction) - 0.5 * (b.high - b.low));
    const double to = std::min(a.high, (middleOf(b) - a.point).dot(a.direction) + 0.5 * (b.high - b.low));
    pair.axis = ContactAxis{a.point + 0.5 * (from + to) * a.direction, a.direction, a.radius, b.radius, a.shaft};
    return pair;
  }
  if (a.shaft && b.shaft) return RegionPair{RegionPair::Kind::Tangent, apart - a.radius - b.radius};
  return std::nullopt;
}

std::optional<RegionPair> compareMixed(const CylinderRegion& cylinder, const PlaneRegion& plane) {
  if (!cylinder.shaft || std::abs(cylinder.direction.dot(plane.normal)) > kParallel) return std::nullopt;
  const double height = plane.normal.dot(middleOf(cylinder)) - plane.offset;
  return RegionPair{RegionPair::Kind::Tangent, height - cylinder.radius};
}

/// Compares cones of one angle on one axis, beside each other. Angles may differ by what changes the gap by a
/// micrometre.
std::optional<RegionPair> compareCones(const RoundRegion& inner, const RoundRegion& outer) {
  constexpr double kSameGap = 1e-6;
  const SurfaceFace& shaft = inner.surface;
  const SurfaceFace& hole = outer.surface;
  if (!areParallel(shaft.axis, hole.axis) || shaft.axis.dot(hole.axis) < 0.0) return std::nullopt;
  const double shift = (hole.point - shaft.point).dot(shaft.axis);
  const double from = std::max(inner.low, outer.low + shift);
  const double to = std::min(inner.high, outer.high + shift);
  if (to - from < kLeastLength) return std::nullopt;
  const double cosine = std::cos(shaft.second);
  if (std::abs(shaft.second - hole.second) * (to - from) > kSameGap * cosine) return std::nullopt;
  const double middle = 0.5 * (from + to);
  const Vector3 point = shaft.point + middle * shaft.axis;
  if ((point - hole.point).cross(hole.axis).norm() > kSameAxis) return std::nullopt;
  const double radius = coneRadiusAt(shaft, middle);
  const double radiusOfHole = coneRadiusAt(hole, middle - shift);
  RegionPair pair{RegionPair::Kind::Nested, cosine * (radiusOfHole - radius)};
  pair.axis = ContactAxis{point, shaft.axis, radius, radiusOfHole, true, true};
  pair.radius = radius;
  return pair;
}

/// Distance of a point from the circle of a torus.
double distanceFromCircle(const SurfaceFace& torus, const Vector3& p) {
  const Vector3 from = p - torus.point;
  const double height = from.dot(torus.axis);
  return std::hypot((from - height * torus.axis).norm() - torus.radius, height);
}

bool areOneCircle(const SurfaceFace& a, const SurfaceFace& b) {
  return areParallel(a.axis, b.axis) && (a.point - b.point).norm() < kSameAxis &&
         std::abs(a.radius - b.radius) < kSameAxis;
}

std::optional<RegionPair> compareRounds(const RoundRegion& inner, const RoundRegion& outer) {
  using Surface = SurfaceFace::Kind;
  const SurfaceFace& shaft = inner.surface;
  const SurfaceFace& hole = outer.surface;
  const auto nested = [](double radius, double radiusOfHole) {
    RegionPair pair{RegionPair::Kind::Nested, radiusOfHole - radius};
    pair.radius = radius;
    return pair;
  };
  if (shaft.kind == Surface::Cone && hole.kind == Surface::Cone) return compareCones(inner, outer);
  if (shaft.kind == Surface::Sphere && hole.kind == Surface::Sphere && (shaft.point - hole.point).norm() < kSameAxis) {
    return nested(shaft.radius, hole.radius);
  }
  if (shaft.kind == Surface::Torus && hole.kind == Surface::Torus && areOneCircle(shaft, hole)) {
    return nested(shaft.second, hole.second);
  }
  if (shaft.kind == Surface::Sphere && hole.kind == Surface::Torus &&
      distanceFromCircle(hole, shaft.point) < kSameAxis) {
    return nested(shaft.radius, hole.second);
  }
  return std::nullopt;
}

/// Compares `a` and `b`, either of which may be the inner one.
std::optional<RegionPair> compareNested(const RoundRegion& a, const RoundRegion& b) {
  if (a.shaft == b.shaft) return std::nullopt;
  auto pair = a.shaft ? compareRounds(a, b) : compareRounds(b, a);
  if (pair && pair->axis && !a.shaft) {
    std::swap(pair->axis->radiusA, pair->axis->radiusB);
    pair->axis->shaftIsA = false;
  }
  return pair;
}

}  // namespace

std::optional<RegionPair> compareRegions(const SurfaceRegions& a, const SurfaceRegions::Label& labelA,
                                         const SurfaceRegions& b, const SurfaceRegions::Label& labelB) {
  if (labelA.kind == Kind::Free || labelB.kind == Kind::Free) return std::nullopt;
  if (labelA.kind == Kind::Round || labelB.kind == Kind::Round) {
    return labelA.kind == labelB.kind ? compareNested(a.rounds[labelA.index], b.rounds[labelB.index]) : std::nullopt;
  }
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
