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

  /// The least lattice whose points reach from the box's least corner at least to its largest one.
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
  Vector3 point(int x, int y, int z) const { return origin + spacing * Vector3(x, y, z); }
};

/// The points of a lattice within a box: first to last along each axis, none where first > last.
struct LatticeRange {
  std::array<int, 3> first{0, 0, 0};
  std::array<int, 3> last{-1, -1, -1};
};

inline LatticeRange rangeWithin(const Lattice& lattice, const Box3& box) {
  LatticeRange range;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<int>(axis);
    const double least = (box.min()[a] - lattice.origin[a]) / lattice.spacing;
    const double most = (box.max()[a] - lattice.origin[a]) / lattice.spacing;
    range.first[axis] = std::max(0, static_cast<int>(std::ceil(least)));
    range.last[axis] = std::min(lattice.counts[axis] - 1, static_cast<int>(std::floor(most)));
  }
  return range;
}

}  // namespace glissade
