#pragma once

#include <cstdint>
#include <queue>
#include <vector>

#include "engine/geometry/triangle_pair.h"

namespace glissade::check {

/// A piece of a flat part of one surface, and the triangles of another surface that can be nearest to its points.
struct PartCell {
  Triangle corners;
  std::vector<std::uint32_t> near;
  Vector3 middle;
  double radius;          ///< of the cell about its middle, metres
  double distance = 0.0;  ///< of the middle from the nearest of them, metres
  double bound = 0.0;     ///< no point of the cell is farther from the surface, metres
};

/// Metres.
double longestEdge(const Triangle& triangle);

/// The cells of a part that may hold a point that is deep below the other surface: the most promising first.
///
/// A depth is the distance from the other surface. So it changes by no more than the way between two points, and it is
/// no more than the distance from one triangle, which is largest at a corner of the cell. Where all triangles that can
/// be nearest face about the same way, it is no more than the cell is below one of their planes; where they are convex,
/// no more than below each of them. So a cell at a common edge of triangles need not become as small as the depth.
class PartCells {
 public:
  /// `triangles`, `normals`: of the other surface, unit, outwards. `near`: those of them that can be nearest to a point
  /// of the part. Refers to `triangles` and `normals`.
  PartCells(const Triangle& part, const std::vector<Triangle>& triangles, const std::vector<Vector3>& normals,
            const std::vector<std::uint32_t>& near);

  bool empty() const { return open_.empty(); }
  /// The cell whose points may be the deepest. Not of none.
  PartCell take();
  void halve(const PartCell& cell);

 private:
  struct IsLess {
    bool operator()(const PartCell& a, const PartCell& b) const { return a.bound < b.bound; }
  };
  PartCell cellOf(const Triangle& corners, const std::vector<std::uint32_t>& near) const;

  double belowPlanes(const PartCell& cell) const;
  bool isConvex(const std::vector<std::uint32_t>& near) const;
  double heightBelow(std::uint32_t triangle, const Vector3& p) const {
    return normals_[triangle].dot(triangles_[triangle][0] - p);
  }

  const std::vector<Triangle>& triangles_;
  const std::vector<Vector3>& normals_;
  std::priority_queue<PartCell, std::vector<PartCell>, IsLess> open_;
};

}  // namespace glissade::check
