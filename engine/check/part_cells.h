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
/// no more than the distance from one triangle, which is largest at a corner of the cell.
class PartCells {
 public:
  /// `triangles`: of the other surface. `near`: those of them that can be nearest to a point of the part.
  PartCells(const Triangle& part, const std::vector<Triangle>& triangles, const std::vector<std::uint32_t>& near);

  bool empty() const { return open_.empty(); }
  /// The cell whose points may be the deepest. Not of none.
  PartCell take();
  void halve(const PartCell& cell);

 private:
  struct IsLess {
    bool operator()(const PartCell& a, const PartCell& b) const { return a.bound < b.bound; }
  };
  PartCell cellOf(const Triangle& corners, const std::vector<std::uint32_t>& near) const;

  const std::vector<Triangle>& triangles_;
  std::priority_queue<PartCell, std::vector<PartCell>, IsLess> open_;
};

}  // namespace glissade::check
