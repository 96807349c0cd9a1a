#pragma once

#include "engine/environment/coverage.h"

namespace glissade {

/// What is known of a body's cells after a motion before they are looked at: where nothing changed they
/// are occupied as they were. Asked by a walk down the octree, in Z order. Refers to `before`.
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
  /// Of a cell's children, in Z order. Precondition: the cell is the root, or its parent was asked for and the
  /// cell is changed partly; it is not a finest one.
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
