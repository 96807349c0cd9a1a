#pragma once

#include <array>
#include <cstdint>

#include "engine/geometry/pose.h"

namespace glissade {

/// A cell of an octree: level 0 is the root cube, level k has 2^k cells along each axis.
struct Cell {
  int level = 0;
  std::array<std::uint32_t, 3> index{0, 0, 0};  ///< index along x, y, z

  friend bool operator==(const Cell&, const Cell&) = default;
};

/// The root cube of an octree, which determines the positions of cells in world coordinates, metres.
struct CellFrame {
  Vector3 origin = Vector3::Zero();  ///< least corner of the root cube
  double side = 1.0;                 ///< edge length of the root cube

  /// The smallest cube on the least corner of a workspace that covers it.
  static CellFrame covering(const Box3& workspace) { return {workspace.min(), workspace.sizes().maxCoeff()}; }

  double cellSize(int level) const { return side / static_cast<double>(1U << static_cast<unsigned>(level)); }
  Box3 box(const Cell& cell) const {
    const double size = cellSize(cell.level);
    const Vector3 least = origin + size * Vector3(cell.index[0], cell.index[1], cell.index[2]);
    return {least, least + Vector3::Constant(size)};
  }
};

/// Position of a finest cell on the Z-order curve (Morton 1966): the cells of any octree cell are
/// consecutive. At most 21 levels.
inline std::uint64_t mortonCode(const std::array<std::uint32_t, 3>& index) {
  const auto spread = [](std::uint64_t v) {
    v = (v | v << 32U) & 0x1f00000000ffffULL;
    v = (v | v << 16U) & 0x1f0000ff0000ffULL;
    v = (v | v << 8U) & 0x100f00f00f00f00fULL;
    v = (v | v << 4U) & 0x10c30c30c30c30c3ULL;
    return (v | v << 2U) & 0x1249249249249249ULL;
  };
  return spread(index[0]) << 2U | spread(index[1]) << 1U | spread(index[2]);
}

/// Number of finest cells (at `depth`) in a cell of the given level.
inline std::uint64_t finestCellsIn(int level, int depth) { return 1ULL << 3U * static_cast<unsigned>(depth - level); }

}  // namespace glissade
