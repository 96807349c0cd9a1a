#pragma once

#include <algorithm>
#include <array>

#include "engine/geometry/pose.h"

namespace glissade {

inline Vector3 nearestOnSegment(const Vector3& a, const Vector3& b, const Vector3& p) {
  const Vector3 along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0.0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return a + t * along;
}

/// Point of a triangle that is nearest to `p`. A degenerate triangle counts as a segment or a point. (C. Ericson,
/// "Real-Time Collision Detection", 2005, section 5.1.5)
inline Vector3 nearestPoint(const std::array<Vector3, 3>& triangle, const Vector3& p) {
  const auto& [a, b, c] = triangle;
  const Vector3 normal = (b - a).cross(c - a);
  const double squared = normal.squaredNorm();
  if (squared > 0.0) {
    const double u = (c - b).cross(p - b).dot(normal);
    const double v = (a - c).cross(p - c).dot(normal);
    const double w = (b - a).cross(p - a).dot(normal);
    if (u >= 0.0 && v >= 0.0 && w >= 0.0) return p - normal * (normal.dot(p - a) / squared);
  }
  Vector3 nearest = nearestOnSegment(a, b, p);
  double least = (nearest - p).squaredNorm();
  const auto take = [&](const Vector3& other) {
    const double distance = (other - p).squaredNorm();
    if (distance >= least) return;
    nearest = other;
    least = distance;
  };
  take(nearestOnSegment(b, c, p));
  take(nearestOnSegment(c, a, p));
  return nearest;
}

}  // namespace glissade
