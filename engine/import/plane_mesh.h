#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "engine/import/loop_triangulation.h"

namespace glissade {

/// Improves triangles of a plane: inner sides are flipped and split. Sides of the boundary are kept.
class PlaneMesh {
 public:
  /// Precondition: the triangles are counter-clockwise; triangles without area are permitted.
  PlaneMesh(std::vector<PlanePoint> points, std::vector<TriangleIndices> triangles);

  /// Flips inner sides until the circumcircle of each triangle contains no corner of its neighbours.
  void makeDelaunay();

  /// Adds a point in the middle of the longest inner side of a triangle. False if it has none.
  bool split(std::size_t triangle);

  const std::vector<PlanePoint>& points() const { return points_; }
  const std::vector<TriangleIndices>& triangles() const { return triangles_; }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  struct Side {
    std::size_t triangle;
    std::size_t corner;  ///< the side runs from this corner to the next one
  };

  void findNeighbours();
  Side otherSideOf(Side side) const;
  void replaceNeighbour(std::size_t of, std::size_t old, std::size_t by);
  bool isToFlip(Side side) const;
  void flip(Side side);
  void makeDelaunayFrom(std::vector<Side> sides);

  std::vector<PlanePoint> points_;
  std::vector<TriangleIndices> triangles_;
  std::vector<std::array<std::size_t, 3>> neighbours_;  ///< neighbour at the side from each corner to the next one
};

}  // namespace glissade
