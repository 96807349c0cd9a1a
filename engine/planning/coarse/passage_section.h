#pragma once

#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

using Point2 = Eigen::Vector2d;

/// Plane coordinates across a world axis: u and v are the next two axes in cyclic order.
Point2 acrossAxis(int axis, const Vector3& p_W);
Vector3 alongAxis(int axis, double s, const Point2& uv);

/// What static bodies leave free of a plane across a world axis, and how far from them a point is.
class PassageSection {
 public:
  /// The sections of the mesh with all planes at `positions` along the axis, near `about`.
  PassageSection(const TriangleMesh& statics_W, int axis, const std::vector<double>& positions, const Point2& about,
                 double reach);

  /// Distance to the nearest outline of any of the planes, positive in free space, negative in solid.
  double signedDistance(const Point2& uv) const;
  bool empty() const { return planes_.empty(); }

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

/// Convex hull, counter-clockwise (Andrew's monotone chain).
std::vector<Point2> convexHull(std::vector<Point2> points);

}  // namespace glissade
