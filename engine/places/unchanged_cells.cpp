#include "engine/places/unchanged_cells.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace glissade {
namespace {

/// About a box of change, times a finest cell: well above rounding.
constexpr double kMargin = 1e-3;

using ChangedBlock = Eigen::AlignedBox3i;

/// Sets of a cell's children as bits, in Z order: per axis those of its lower and those of its upper half.
constexpr std::array<std::array<unsigned, 2>, 3> kHalves{{{0x0f, 0xf0}, {0x33, 0xcc}, {0x55, 0xaa}}};

/// Precondition: the box meets the cell.
unsigned childrenMet(const ChangedBlock& box, const ChangedBlock& cell) {
  unsigned children = 0xff;
  for (int axis = 0; axis < 3; ++axis) {
    const int upper = (cell.min()[axis] + cell.max()[axis] + 1) / 2;
    const auto& [low, high] = kHalves[static_cast<std::size_t>(axis)];
    children &= (box.min()[axis] < upper ? low : 0) | (box.max()[axis] >= upper ? high : 0);
  }
  return children;
}

unsigned childrenHeld(const ChangedBlock& box, const ChangedBlock& cell) {
  unsigned children = 0xff;
  for (int axis = 0; axis < 3; ++axis) {
    const int upper = (cell.min()[axis] + cell.max()[axis] + 1) / 2;
    const auto& [low, high] = kHalves[static_cast<std::size_t>(axis)];
    children &= (box.min()[axis] <= cell.min()[axis] && box.max()[axis] >= upper - 1 ? low : 0) |
                (box.min()[axis] <= upper && box.max()[axis] >= cell.max()[axis] ? high : 0);
  }
  return children;
}

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
  const ChangedBlock block =
      ChangedBlock(cellOf(box.min(), -kMargin), cellOf(box.max(), kMargin)).intersection(blockOf(Cell{}));
  if (!block.isEmpty()) changed_.push_back(block);
}

UnchangedCells::Block UnchangedCells::blockOf(const Cell& cell) const {
  const int size = 1 << (depth_ - cell.level);
  const auto& [x, y, z] = cell.index;
  const Eigen::Vector3i first = size * Eigen::Vector3i(static_cast<int>(x), static_cast<int>(y), static_cast<int>(z));
  return {first, first + Eigen::Vector3i::Constant(size - 1)};
}

std::array<UnchangedCells::Change, 8> UnchangedCells::changesIn(const Cell& cell) {
  const ChangedBlock block = blockOf(cell);
  const auto level = static_cast<std::size_t>(cell.level);
  auto& meeting = meeting_[level];
  if (level > 0) {
    const auto meets = [&](std::uint32_t i) { return changed_[i].intersects(block); };
    meeting.clear();
    std::copy_if(meeting_[level - 1].begin(), meeting_[level - 1].end(), std::back_inserter(meeting), meets);
  }
  unsigned met = 0;
  unsigned held = 0;
  for (const std::uint32_t i : meeting) {
    met |= childrenMet(changed_[i], block);
    held |= childrenHeld(changed_[i], block);
  }
  std::array<Change, 8> changes{};
  for (unsigned child = 0; child < 8; ++child) {
    changes[child] = (held >> child & 1U) != 0  ? Change::Wholly
                     : (met >> child & 1U) != 0 ? Change::Partly
                                                : Change::None;
  }
  return changes;
}

std::array<std::uint32_t, 3> UnchangedCells::changedCellIn(const Cell& cell) const {
  const ChangedBlock block = blockOf(cell);
  const auto& candidates = meeting_[static_cast<std::size_t>(std::max(0, cell.level - 1))];
  const auto meets = [&](std::uint32_t i) { return changed_[i].intersects(block); };
  const auto found = std::find_if(candidates.begin(), candidates.end(), meets);
  const Eigen::Vector3i first = changed_[*found].intersection(block).min();
  return {static_cast<std::uint32_t>(first.x()), static_cast<std::uint32_t>(first.y()),
          static_cast<std::uint32_t>(first.z())};
}

void UnchangedCells::copy(const CellRun& cells, CellRuns& target) {
  while (next_ != end_ && next_->end <= cells.begin) ++next_;
  for (; next_ != end_ && next_->begin < cells.end; ++next_) {
    addRun(target, {std::max(next_->begin, cells.begin), std::min(next_->end, cells.end)});
    if (next_->end > cells.end) return;
  }
}

}  // namespace glissade
