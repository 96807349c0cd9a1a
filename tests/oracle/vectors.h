#pragma once

#include <array>
#include <cmath>
#include <vector>

/// Vectors of the oracle, which shares no code with the engine.
namespace glissade::oracle {

using Point = std::array<double, 3>;
using Triangle = std::array<Point, 3>;
using Triangles = std::vector<Triangle>;
/// A quaternion in the order x, y, z, w.
using Rotation = std::array<double, 4>;

struct Placement {
  Point position{0.0, 0.0, 0.0};
  Rotation orientation{0.0, 0.0, 0.0, 1.0};
};

inline Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Point operator*(double s, const Point& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Point& a) { return std::sqrt(dot(a, a)); }

/// The point rotated by the rows of the rotation matrix.
inline Point rotated(const Rotation& q, const Point& p) {
  const double n = 2.0 / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  const auto [x, y, z, w] = q;
  return {p[0] + n * (-(y * y + z * z) * p[0] + (x * y - w * z) * p[1] + (x * z + w * y) * p[2]),
          p[1] + n * ((x * y + w * z) * p[0] - (x * x + z * z) * p[1] + (y * z - w * x) * p[2]),
          p[2] + n * ((x * z - w * y) * p[0] + (y * z + w * x) * p[1] - (x * x + y * y) * p[2])};
}
inline Point placed(const Placement& X, const Point& p) { return rotated(X.orientation, p) + X.position; }

inline Triangles placed(const Placement& X, const Triangles& triangles) {
  Triangles result;
  result.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) result.push_back({placed(X, a), placed(X, b), placed(X, c)});
  return result;
}

}  // namespace glissade::oracle
