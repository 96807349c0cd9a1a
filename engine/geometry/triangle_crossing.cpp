#include "engine/geometry/triangle_crossing.h"

#include <algorithm>
#include <limits>

namespace glissade {
namespace {

/// Least length of the common part of two crossing triangles, in multiples of the depth of a touch.
constexpr double kLength = 10.0;

using Heights = std::array<double, 3>;

/// Unit normal; zero where the triangle has no area.
Vector3 normalOf(const Triangle& t) { return (t[1] - t[0]).cross(t[2] - t[0]).stableNormalized(); }

Heights heightsOver(const Triangle& plane, const Vector3& normal, const Triangle& t) {
  return {normal.dot(t[0] - plane[0]), normal.dot(t[1] - plane[0]), normal.dot(t[2] - plane[0])};
}

bool areOnBothSides(const Heights& heights, double near) {
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  return *low<-near&& * high> near;
}

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

/// Interval along the direction in which the triangle meets the plane over which it has these heights.
Interval inPlane(const Triangle& t, const Heights& heights, const Vector3& direction) {
  Interval interval;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = (i + 1) % 3;
    if ((heights[i] < 0.0) == (heights[k] < 0.0)) continue;
    const double share = heights[i] / (heights[i] - heights[k]);
    const double at = direction.dot(t[i] + share * (t[k] - t[i]));
    interval.low = std::min(interval.low, at);
    interval.high = std::max(interval.high, at);
  }
  return interval;
}

}  // namespace

bool trianglesCross(const Triangle& a, const Triangle& b, double near) {
  const Vector3 normalOfA = normalOf(a);
  const Vector3 normalOfB = normalOf(b);
  if (normalOfA.isZero(0.0) || normalOfB.isZero(0.0)) return trianglesMeet(a, b);
  const Heights ofA = heightsOver(b, normalOfB, a);
  if (!areOnBothSides(ofA, near)) return false;
  const Heights ofB = heightsOver(a, normalOfA, b);
  if (!areOnBothSides(ofB, near)) return false;
  const Vector3 along = normalOfA.cross(normalOfB).stableNormalized();
  const Interval one = inPlane(a, ofA, along);
  const Interval other = inPlane(b, ofB, along);
  return std::min(one.high, other.high) - std::max(one.low, other.low) > kLength * near;
}

}  // namespace glissade
