#include "engine/evidence/deepest_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace glissade::evidence {
namespace {

constexpr double kSameNormal = 1.0 - 1e-9;
constexpr double kSameShare = 1e-4;  ///< share of a segment: points that are closer count as one
/// With more planes, points at equal distances are taken instead of the intersections of each pair.
constexpr std::size_t kMostPlanes = 24;
constexpr int kEqualParts = 8;

struct Plane {
  Vector3 normal;  ///< unit
  double offset;

  double height(const Vector3& p) const { return normal.dot(p) - offset; }
};

struct Segment {
  Vector3 from;
  Vector3 to;
};

std::optional<Plane> planeOf(const Triangle& triangle) {
  const Vector3 doubled = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  if (!(doubled.norm() > 0.0)) return std::nullopt;
  const Vector3 normal = doubled.normalized();
  return Plane{normal, normal.dot(triangle[0])};
}

/// The intersection of the triangle and the plane.
std::optional<Segment> cut(const Triangle& triangle, const Plane& plane) {
  std::vector<Vector3> ends;
  for (std::size_t i = 0; i < 3; ++i) {
    const double one = plane.height(triangle[i]);
    const double other = plane.height(triangle[(i + 1) % 3]);
    if ((one < 0.0) == (other < 0.0)) continue;
    ends.emplace_back(triangle[i] + one / (one - other) * (triangle[(i + 1) % 3] - triangle[i]));
  }
  if (ends.size() != 2) return std::nullopt;
  return Segment{ends[0], ends[1]};
}

using Coordinates = std::array<double, 3>;

Coordinates coordinatesOf(const Vector3& p) { return {p.x(), p.y(), p.z()}; }

class Points {
 public:
  Points(const Triangle& part, const std::vector<Triangle>& near) : part_(part) {
    for (const Triangle& triangle : near) {
      const auto plane = planeOf(triangle);
      if (plane) addPlane(*plane);
    }
    findBisectors(near);
  }

  std::vector<Vector3> all() {
    points_.emplace_back((part_[0] + part_[1] + part_[2]) / 3.0);
    for (std::size_t i = 0; i < 3; ++i) along({part_[i], part_[(i + 1) % 3]});
    for (const Plane& bisector : bisectors_) {
      if (const auto segment = cut(part_, bisector)) along(*segment);
    }
    return std::move(points_);
  }

 private:
  void addPlane(const Plane& plane) {
    const double same = 1e-9 * (part_[1] - part_[0]).norm();
    const bool known = std::any_of(planes_.begin(), planes_.end(), [&](const Plane& each) {
      return each.normal.dot(plane.normal) > kSameNormal && std::abs(each.offset - plane.offset) <= same;
    });
    if (!known) planes_.push_back(plane);
  }

  /// Finds the bisecting planes through the common edges of neighbours.
  void findBisectors(const std::vector<Triangle>& near) {
    std::map<std::pair<Coordinates, Coordinates>, Vector3> open;
    for (const Triangle& triangle : near) {
      const auto plane = planeOf(triangle);
      if (!plane) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const Coordinates a = coordinatesOf(triangle[i]);
        const Coordinates b = coordinatesOf(triangle[(i + 1) % 3]);
        const auto [at, isNew] = open.try_emplace(std::minmax(a, b), plane->normal);
        if (isNew || at->second.dot(plane->normal) > kSameNormal) continue;
        const Vector3 across = (at->second - plane->normal).normalized();
        bisectors_.push_back({across, across.dot(triangle[i])});
      }
    }
  }

  /// Adds points where two planes are equally far, and the midpoints between them.
  void along(const Segment& segment) {
    std::vector<double> shares{0.0, 1.0};
    const bool few = planes_.size() <= kMostPlanes;
    for (int i = 1; i < kEqualParts && !few; ++i) shares.push_back(static_cast<double>(i) / kEqualParts);
    for (std::size_t i = 0; i < planes_.size() && few; ++i) {
      const double from = planes_[i].height(segment.from);
      const double rise = planes_[i].height(segment.to) - from;
      addShare(-from, rise, shares);
      for (std::size_t k = 0; k < i; ++k) {
        const double other = planes_[k].height(segment.from);
        addShare(other - from, rise - (planes_[k].height(segment.to) - other), shares);
      }
    }
    std::sort(shares.begin(), shares.end());
    double last = -1.0;
    for (const double share : shares) {
      if (share - last < kSameShare) continue;
      if (last >= 0.0) add(segment, 0.5 * (last + share));
      add(segment, share);
      last = share;
    }
  }

  static void addShare(double way, double rise, std::vector<double>& shares) {
    if (rise == 0.0) return;
    const double share = way / rise;
    if (share > 0.0 && share < 1.0) shares.push_back(share);
  }

  void add(const Segment& segment, double share) {
    points_.emplace_back(segment.from + share * (segment.to - segment.from));
  }

  const Triangle& part_;
  std::vector<Plane> planes_;
  std::vector<Plane> bisectors_;
  std::vector<Vector3> points_;
};

}  // namespace

std::vector<Vector3> deepestPoints(const Triangle& part, const std::vector<Triangle>& near) {
  return Points(part, near).all();
}

}  // namespace glissade::evidence
