#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "engine/import/loop_triangulation.h"

namespace glissade {

/// Triangles of a plane that are made better: inner sides are flipped and split. Sides of the boundary stay.
class PlaneMesh {
 public:
  /// Precondition: the triangles run counter-clockwise; those without area are allowed.
  PlaneMesh(std::vector<PlanePoint> points, std::vector<TriangleIndices> triangles);

  /// Flips inner sides until each circle about a triangle holds no corner of its neighbours.
  void makeDelaunay();

  /// Puts a point into the middle of the longest inner side of a triangle. False where it has none.
  bool split(std::size_t triangle);

  const std::vector<PlanePoint>& points() const { return points_; }
  const std::vector<TriangleIndices>& triangles() const { return triangles_; }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  struct Side {
    std::size_t triangle;
    std::size_t corner;  ///< the side runs from it to the next corner
  };

  void findNeighbours();
  Side otherSideOf(Side side) const;
  void replaceNeighbour(std::size_t of, std::size_t old, std::size_t by);
  bool isToFlip(Side side) const;
  void flip(Side side);
  void makeDelaunayFrom(std::vector<Side> sides);

  std::vector<PlanePoint> points_;
  std::vector<TriangleIndices> triangles_;
  std::vector<std::array<std::size_t, 3>> neighbours_;  ///< beyond the side from a corner to the next one
};

}  // namespace glissade
