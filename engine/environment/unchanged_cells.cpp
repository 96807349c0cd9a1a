#include "engine/environment/unchanged_cells.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace glissade {
namespace {

/// About a box of change, times a finest cell: well above rounding.
constexpr double kMargin = 1e-3;

}  // namespace

UnchangedCells::UnchangedCells(const CellRuns& before, const std::vector<Box3>& changed, const CellFrame& frame,
                               int depth)
    : depth_(depth), next_(before.begin()), end_(before.end()) {
  for (const Box3& box : changed) addBlock(box, frame);
  meeting_.resize(static_cast<std::size_t>(depth) + 1);
  meeting_[0].resize(changed_.size());
  std::iota(meeting_[0].begin(), meeting_[0].end(), 0U);
}

void UnchangedCells::addBlock(const Box3& box, const CellFrame& frame) {
  const auto cellOf = [&](const Vector3& corner, double margin) -> Eigen::Vector3i {
    const Vector3 at = ((corner - frame.origin) / frame.cellSize(depth_)).array() + margin;
    // Far outside is as good as just outside.
    return at.array().floor().cwiseMax(-1.0).cwiseMin(std::ldexp(1.0, depth_)).matrix().cast<int>();
  };
  const Block block = Block(cellOf(box.min(), -kMargin), cellOf(box.max(), kMargin)).intersection(blockOf(Cell{}));
  if (!block.isEmpty()) changed_.push_back(block);
}

UnchangedCells::Block UnchangedCells::blockOf(const Cell& cell) const {
  const int size = 1 << (depth_ - cell.level);
  const auto& [x, y, z] = cell.index;
  const Eigen::Vector3i first = size * Eigen::Vector3i(static_cast<int>(x), static_cast<int>(y), static_cast<int>(z));
  return {first, first + Eigen::Vector3i::Constant(size - 1)};
}

UnchangedCells::Change UnchangedCells::changeOf(const Cell& cell) {
  const Block block = blockOf(cell);
  auto& meeting = meeting_[static_cast<std::size_t>(cell.level)];
  meeting.clear();
  for (const std::uint32_t i : meeting_[static_cast<std::size_t>(cell.level) - 1]) {
    if (!changed_[i].intersects(block)) continue;
    if (changed_[i].contains(block)) return Change::Wholly;
    meeting.push_back(i);
  }
  return meeting.empty() ? Change::None : Change::Partly;
}

void UnchangedCells::copy(const CellRun& cells, CellRuns& target) {
  while (next_ != end_ && next_->end <= cells.begin) ++next_;
  for (; next_ != end_ && next_->begin < cells.end; ++next_) {
    addRun(target, {std::max(next_->begin, cells.begin), std::min(next_->end, cells.end)});
    if (next_->end > cells.end) return;
  }
}

}  // namespace glissade
