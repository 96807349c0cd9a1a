#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/geometry/triangle_pair.h"

namespace glissade::evidence {

/// A piece of a flat part of one surface, and the triangles of another surface that can be nearest to its points.
struct PartCell {
  Triangle corners;
  std::vector<std::uint32_t> near;
  bool convex = false;  ///< whether none of the near triangles is above the plane of another one; not of many triangles
  Vector3 middle = Vector3::Zero();
  double radius = 0.0;    ///< radius of the cell about its middle, metres
  double distance = 0.0;  ///< distance of the middle from the nearest of the triangles, metres
  double bound = 0.0;     ///< upper bound on the distance of points of the cell from the surface, metres
};

/// Length in metres.
double longestEdge(const Triangle& triangle);

/// The cells of a part that may contain a point deep below the other surface; the one with the largest bound first.
///
/// A depth is the distance from the other surface. It changes by no more than the distance of two points, and it is no
/// more than the distance from one triangle, which is largest at a corner of the cell. If all triangles that can be
/// nearest face about the same way, it is no more than the depth below one of their planes; if they are convex, no more
/// than the depth below each of them. A cell at a common edge of triangles therefore need not become as small as the
/// depth.
class PartCells {
 public:
  /// `triangles`, `normals`: of the other surface; normals are unit and point outwards. `near`: indices of the
  /// triangles that can be nearest to a point of the part. Refers to `triangles` and `normals`.
  PartCells(const Triangle& part, const std::vector<Triangle>& triangles, const std::vector<Vector3>& normals,
            const std::vector<std::uint32_t>& near);

  bool empty() const { return open_.empty(); }
  /// Takes the cell with the largest bound. Precondition: not empty().
  PartCell take();
  void halve(const PartCell& cell);

 private:
  static bool isLess(const PartCell& a, const PartCell& b) { return a.bound < b.bound; }
  void push(PartCell cell);
  /// The cell of a part of `parent`.
  PartCell cellOf(const Triangle& corners, const PartCell& parent) const;
  static bool canBeNearest(const Vector3& away, const PartCell& cell, const std::array<double, 3>& atCorners);
  double belowPlanes(const PartCell& cell) const;
  bool isConvex(const std::vector<std::uint32_t>& near) const;
  double heightBelow(std::uint32_t triangle, const Vector3& p) const {
    return normals_[triangle].dot(triangles_[triangle][0] - p);
  }

  const std::vector<Triangle>& triangles_;
  const std::vector<Vector3>& normals_;
  std::vector<PartCell> open_;  ///< a heap by isLess()
};

}  // namespace glissade::evidence
