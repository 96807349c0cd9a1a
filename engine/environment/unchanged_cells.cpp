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
  const double size = frame.cellSize(depth_);
  const double count = std::ldexp(1.0, depth_);
  Block block{};
  for (int axis = 0; axis < 3; ++axis) {
    const double low = std::floor((box.min()[axis] - frame.origin[axis]) / size - kMargin);
    const double high = std::floor((box.max()[axis] - frame.origin[axis]) / size + kMargin);
    if (high < 0.0 || low >= count) return;
    block.first[static_cast<std::size_t>(axis)] = static_cast<std::uint32_t>(std::max(low, 0.0));
    block.last[static_cast<std::size_t>(axis)] = static_cast<std::uint32_t>(std::min(high, count - 1.0));
  }
  changed_.push_back(block);
}

bool UnchangedCells::meet(const Block& a, const Block& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (a.first[axis] > b.last[axis] || b.first[axis] > a.last[axis]) return false;
  }
  return true;
}

bool UnchangedCells::holds(const Block& outer, const Block& inner) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (inner.first[axis] < outer.first[axis] || inner.last[axis] > outer.last[axis]) return false;
  }
  return true;
}

UnchangedCells::Block UnchangedCells::blockOf(const Cell& cell) const {
  const unsigned shift = static_cast<unsigned>(depth_ - cell.level);
  const std::uint32_t last = (1U << shift) - 1U;
  const auto& [x, y, z] = cell.index;
  return {{x << shift, y << shift, z << shift}, {(x << shift) + last, (y << shift) + last, (z << shift) + last}};
}

UnchangedCells::Change UnchangedCells::changeOf(const Cell& cell) {
  const Block block = blockOf(cell);
  auto& meeting = meeting_[static_cast<std::size_t>(cell.level)];
  meeting.clear();
  for (const std::uint32_t i : meeting_[static_cast<std::size_t>(cell.level) - 1]) {
    if (!meet(changed_[i], block)) continue;
    if (holds(changed_[i], block)) return Change::Wholly;
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
