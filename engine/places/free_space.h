#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/places/octree.h"

namespace glissade {

/// The cells of one octree level inside the workspace, as a flat array: x slowest, z fastest. Fewer than 2^32.
struct CellGrid {
  CellFrame frame;
  int level = 0;
  std::array<int, 3> counts{0, 0, 0};

  std::size_t size() const {
    return static_cast<std::size_t>(counts[0]) * static_cast<std::size_t>(counts[1]) *
           static_cast<std::size_t>(counts[2]);
  }
  double cellSize() const { return frame.cellSize(level); }
  std::size_t at(int x, int y, int z) const {
    return (static_cast<std::size_t>(x) * static_cast<std::size_t>(counts[1]) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(counts[2]) +
           static_cast<std::size_t>(z);
  }
  /// Inline and with two short divisions, because it is called for every cell several times while an environment model
  /// is built.
  std::array<int, 3> coordinates(std::size_t cell) const {
    const auto index = static_cast<std::uint32_t>(cell);
    const auto ny = static_cast<std::uint32_t>(counts[1]);
    const auto nz = static_cast<std::uint32_t>(counts[2]);
    const std::uint32_t column = index / nz;
    const std::uint32_t x = column / ny;
    return {static_cast<int>(x), static_cast<int>(column - x * ny), static_cast<int>(index - column * nz)};
  }
  /// Distance in the flat array between neighbours along an axis.
  std::size_t stride(int axis) const {
    if (axis == 2) return 1;
    const auto nz = static_cast<std::size_t>(counts[2]);
    return axis == 1 ? nz : nz * static_cast<std::size_t>(counts[1]);
  }
  bool contains(const std::array<int, 3>& coordinates) const;
  Vector3 centre(std::size_t cell) const;
  Box3 box(std::size_t cell) const;
  /// The cell that holds a point; nothing outside the workspace.
  std::optional<std::size_t> find(const Vector3& p_W) const;
  /// Calls visit(neighbour) for the up to six cells that share a face.
  template <class Visit>
  void forEachNeighbour(std::size_t cell, Visit&& visit) const {
    const std::array<int, 3> c = coordinates(cell);
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      if (c[a] > 0) visit(cell - stride(axis));
      if (c[a] + 1 < counts[a]) visit(cell + stride(axis));
    }
  }
  /// Calls visit(neighbour) for the up to four neighbours in the same slice perpendicular to an axis.
  template <class Visit>
  void forEachNeighbourAcross(int axis, std::size_t cell, Visit&& visit) const {
    const std::array<int, 3> c = coordinates(cell);
    for (int other = 0; other < 3; ++other) {
      if (other == axis) continue;
      const auto o = static_cast<std::size_t>(other);
      if (c[o] > 0) visit(cell - stride(other));
      if (c[o] + 1 < counts[o]) visit(cell + stride(other));
    }
  }
};

/// Input of the topological layer: the kind of each cell of one level (paper 2, section 3.2: mobile bodies do not shape
/// the topology).
struct FreeSpace {
  CellGrid grid;
  std::vector<CellKind> kinds;  ///< the worst kind among the finest cells in each cell

  bool open(std::size_t cell) const { return kinds[cell] != CellKind::Static; }
};

/// Precondition: 0 <= level <= octree.depth().
FreeSpace freeSpaceOf(const Octree& octree, int level);

/// Distance from each open cell's centre to the nearest cell that is not open (mobile bodies close a
/// cell where `mobileToo`), or to the outside of the workspace, metres; 0 elsewhere. Exact for cell centres, linear in
/// the cells (Felzenszwalb and Huttenlocher 2012). Unfinished after a stop.
std::vector<double> distanceTransform(const FreeSpace& space, bool mobileToo = false, const StopToken& stop = {});

}  // namespace glissade
