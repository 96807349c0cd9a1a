#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "engine/geometry/pose.h"

namespace glissade {

/// Points at equal distances along the axes of a frame; x slowest, z fastest.
struct Lattice {
  Vector3 origin = Vector3::Zero();  ///< the point (0, 0, 0), metres
  double spacing = 0.0;              ///< metres
  std::array<int, 3> counts{0, 0, 0};

  /// The smallest lattice that begins at the box's least corner and covers the box.
  static Lattice over(const Box3& box, double spacing) {
    Lattice lattice{box.min(), spacing, {}};
    for (int axis = 0; axis < 3; ++axis) {
      lattice.counts[static_cast<std::size_t>(axis)] = static_cast<int>(std::ceil(box.sizes()[axis] / spacing)) + 1;
    }
    return lattice;
  }

  std::size_t size() const {
    return static_cast<std::size_t>(counts[0]) * static_cast<std::size_t>(counts[1]) *
           static_cast<std::size_t>(counts[2]);
  }
  std::size_t at(int x, int y, int z) const {
    return (static_cast<std::size_t>(x) * static_cast<std::size_t>(counts[1]) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(counts[2]) +
           static_cast<std::size_t>(z);
  }
  std::array<int, 3> coordinates(std::size_t point) const {
    const auto ny = static_cast<std::size_t>(counts[1]);
    const auto nz = static_cast<std::size_t>(counts[2]);
    return {static_cast<int>(point / (ny * nz)), static_cast<int>(point / nz % ny), static_cast<int>(point % nz)};
  }
  bool has(const std::array<int, 3>& at) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (at[axis] < 0 || at[axis] >= counts[axis]) return false;
    }
    return true;
  }
  /// A corner of a cell, as bits (x: 4, y: 2, z: 1); `cell`: the point where the cell begins.
  std::size_t cornerAt(const std::array<int, 3>& cell, int corner) const {
    return at(cell[0] + (corner >> 2), cell[1] + (corner >> 1 & 1), cell[2] + (corner & 1));
  }
  Vector3 point(int x, int y, int z) const { return origin + spacing * Vector3(x, y, z); }
};

}  // namespace glissade
