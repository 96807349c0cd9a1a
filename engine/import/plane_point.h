#pragma once

#include <Eigen/Core>

namespace glissade {

using PlanePoint = Eigen::Vector2d;

inline double crossProduct(const PlanePoint& a, const PlanePoint& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Twice the area of a triangle; negative if it is clockwise.
inline double doubleArea(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return crossProduct(b - a, c - a);
}

}  // namespace glissade
