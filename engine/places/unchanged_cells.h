#pragma once

#include "engine/places/coverage.h"

namespace glissade {

/// The cells of a body that a motion left unchanged: they are occupied as before and need not be examined. Queries must
/// follow a walk down the octree in Z order. The object keeps a reference to `before`.
class UnchangedCells {
 public:
  /// `changed`: boxes outside which the body covers the same as before (changedBoxes()).
  UnchangedCells(const CellRuns& before, const std::vector<Box3>& changed, const CellFrame& frame, int depth);

  bool anyChanged() const { return !changed_.empty(); }

  enum class Change {
    None,    ///< no box of change meets the cell
    Partly,  ///< of its children some may be unchanged
    Wholly   ///< one box holds the cell
  };
  /// The changes of a cell's children, in Z order. Precondition: the cell is the root, or its parent was queried and
  /// the cell is changed partly; it is not a finest cell.
  std::array<Change, 8> changesIn(const Cell& cell);
  /// One of a cell's finest cells that may have changed. Precondition: there is one, and as for changesIn().
  std::array<std::uint32_t, 3> changedCellIn(const Cell& cell) const;
  /// Appends what was occupied of these finest cells. Precondition: no cells behind them were asked for.
  void copy(const CellRun& cells, CellRuns& target);

 private:
  using Block = Eigen::AlignedBox3i;  ///< of finest cells, the last ones included

  Block blockOf(const Cell& cell) const;
  void addBlock(const Box3& box, const CellFrame& frame);

  int depth_;
  CellRuns::const_iterator next_;  ///< the first run that may still be asked for
  CellRuns::const_iterator end_;
  std::vector<Block> changed_;
  std::vector<std::vector<std::uint32_t>> meeting_;  ///< per level below the root: those that meet the cell asked for
};

}  // namespace glissade
