#include "engine/evidence/turn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace glissade::evidence {
namespace {

using Flat = Eigen::Vector2d;

double distanceFromOrigin(const Flat& a, const Flat& b) {
  const Flat way = b - a;
  const double length = way.squaredNorm();
  const double t = length > 0.0 ? std::clamp(-a.dot(way) / length, 0.0, 1.0) : 0.0;
  return (a + t * way).norm();
}

double side(const Flat& a, const Flat& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Gap between two intervals; 0 if they overlap.
double apart(double lowA, double highA, double lowB, double highB) {
  return std::max({0.0, lowB - highA, lowA - highB});
}

}  // namespace

double apartTurned(const TurnedTriangle& a, const TurnedTriangle& b) {
  return std::hypot(apart(a.nearest, a.farthest, b.nearest, b.farthest), apart(a.low, a.high, b.low, b.high));
}

TurnedTriangle turned(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& point, const Vector3& axis) {
  const Vector3 u = axis.unitOrthogonal();
  const Vector3 v = axis.cross(u);
  std::array<Flat, 3> flat;
  std::array<double, 3> heights{};
  const std::array<const Vector3*, 3> corners{&a, &b, &c};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 p = *corners[i] - point;
    flat[i] = {p.dot(u), p.dot(v)};
    heights[i] = p.dot(axis);
  }
  const std::array<double, 3> sides{side(flat[0], flat[1]), side(flat[1], flat[2]), side(flat[2], flat[0])};
  const auto [least, most] = std::minmax_element(sides.begin(), sides.end());
  const bool around = *least >= 0.0 || *most <= 0.0;
  const double nearest = around && *least != *most
                             ? 0.0
                             : std::min({distanceFromOrigin(flat[0], flat[1]), distanceFromOrigin(flat[1], flat[2]),
                                         distanceFromOrigin(flat[2], flat[0])});
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  return {nearest, std::max({flat[0].norm(), flat[1].norm(), flat[2].norm()}), *low, *high};
}

double turnedDistance(const std::vector<TurnedTriangle>& moving, const std::vector<TurnedTriangle>& fixed,
                      const Rise& rise, const StopToken& stop) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr std::size_t kBetweenStops = 64;
  std::vector<TurnedTriangle> passed;
  TurnedTriangle all{kInfinity, 0.0, kInfinity, -kInfinity};
  for (const TurnedTriangle& triangle : moving) {
    passed.push_back({triangle.nearest - rise.off, triangle.farthest + rise.off, triangle.low + rise.least - rise.off,
                      triangle.high + rise.most + rise.off});
    const TurnedTriangle& last = passed.back();
    all = {std::min(all.nearest, last.nearest), std::max(all.farthest, last.farthest), std::min(all.low, last.low),
           std::max(all.high, last.high)};
  }
  double least = kInfinity;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    if (i % kBetweenStops == 0 && stop.stopRequested()) return 0.0;
    if (apartTurned(all, fixed[i]) >= least) continue;
    for (const TurnedTriangle& triangle : passed) least = std::min(least, apartTurned(triangle, fixed[i]));
  }
  return least;
}

}  // namespace glissade::evidence
