#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/triangle_mesh.h"
#include "engine/places/cell.h"

namespace glissade {

/// Tells for finest cells that a closed surface does not cross whether they lie in its solid: one
/// vertical ray a column of cells, all crossings found in one pass over the triangles.
class InsideColumns {
 public:
  /// For the columns that go through one of the boxes.
  InsideColumns(const TriangleMesh& mesh_W, const CellFrame& frame, int depth, const std::vector<Box3>& boxes);

  /// Precondition: the surface does not cross the finest cell at `index`, which is in a column that was asked for.
  bool inside(const std::array<std::uint32_t, 3>& index) const;

 private:
  struct Crossing {
    double z;
    std::int32_t turns;  ///< +1 where the surface faces up, -1 where down
    std::int32_t next;   ///< of the same column; kNone: the last
  };

  static constexpr std::int32_t kNone = -1;
  static constexpr std::int32_t kNotAskedFor = -2;
  using ColumnRange = std::array<std::array<std::uint32_t, 2>, 2>;  ///< per axis: first and last

  ColumnRange rangeOf(const Box3& box) const;
  void askFor(const Box3& box);
  void addTriangle(const std::array<Vector3, 3>& triangle);
  std::size_t column(std::uint32_t x, std::uint32_t y) const { return (x - first_[0]) * counts_[1] + (y - first_[1]); }
  double coordinate(std::uint32_t index, int axis) const;

  CellFrame frame_;
  double size_;
  std::array<std::uint32_t, 2> first_{0, 0};
  std::array<std::uint32_t, 2> counts_{0, 0};
  std::vector<std::int32_t> last_;  ///< per column: the crossing found last, or why there is none
  std::vector<Crossing> crossings_;
};

}  // namespace glissade
