#pragma once

#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

using Point2 = Eigen::Vector2d;

/// Plane coordinates across a world axis: u and v are the next two axes in cyclic order.
Point2 acrossAxis(int axis, const Vector3& p_W);
Vector3 alongAxis(int axis, double s, const Point2& uv);

/// The part of a plane across a world axis that static bodies leave free, with the distance of points from these
/// bodies.
class PassageSection {
 public:
  /// The sections of the mesh with all planes at `positions` along the axis, near `about`.
  PassageSection(const TriangleMesh& statics_W, int axis, const std::vector<double>& positions, const Point2& about,
                 double reach);

  /// Distance to the nearest outline of any of the planes, positive in free space, negative in solid.
  double signedDistance(const Point2& uv) const;

 private:
  /// An outline's piece; the solid lies to its left.
  struct Segment {
    Point2 a;
    Point2 b;
  };
  using Plane = std::vector<Segment>;

  static double signedDistance(const Plane& plane, const Point2& uv);
  std::vector<Plane> planes_;
  double reach_;
};

/// The signed distances of a section on a lattice, interpolated between its points: quick, and off by
/// no more than a step of the lattice.
class SampledSection {
 public:
  SampledSection(const PassageSection& section, const Eigen::AlignedBox2d& box, int points);

  /// Beyond the box the value at its rim.
  double signedDistance(const Point2& uv) const;
  double step() const { return step_.maxCoeff(); }

 private:
  Eigen::AlignedBox2d box_;
  int points_;
  Point2 step_;
  std::vector<double> values_;
};

/// Convex hull, counter-clockwise (Andrew's monotone chain).
std::vector<Point2> convexHull(std::vector<Point2> points);

/// Points along a closed outline, its corners among them, no more than `spacing` apart.
std::vector<Point2> pointsAlong(const std::vector<Point2>& outline, double spacing);

}  // namespace glissade
