#include "engine/places/free_space.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glissade {

bool CellGrid::contains(const std::array<int, 3>& c) const {
  for (std::size_t i = 0; i < 3; ++i) {
    if (c[i] < 0 || c[i] >= counts[i]) return false;
  }
  return true;
}

Vector3 CellGrid::centre(std::size_t cell) const {
  const auto c = coordinates(cell);
  return frame.origin + cellSize() * (Vector3(c[0], c[1], c[2]) + Vector3::Constant(0.5));
}

Box3 CellGrid::box(std::size_t cell) const {
  const Vector3 half = Vector3::Constant(cellSize() / 2.0);
  const Vector3 middle = centre(cell);
  return {middle - half, middle + half};
}

std::optional<std::size_t> CellGrid::find(const Vector3& p_W) const {
  const Vector3 scaled = (p_W - frame.origin) / cellSize();
  constexpr double kRounding = 1e-9;
  std::array<int, 3> c{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    if (!(scaled[axis] >= 0.0 && scaled[axis] <= counts[a] + kRounding)) return std::nullopt;
    // A point on the far face belongs to the last cell.
    c[a] = std::min(static_cast<int>(scaled[axis]), counts[a] - 1);
  }
  return at(c[0], c[1], c[2]);
}

FreeSpace freeSpaceOf(const Octree& octree, int level) {
  FreeSpace space;
  space.grid.frame = octree.frame();
  space.grid.level = level;
  const double size = octree.frame().cellSize(level);
  for (int axis = 0; axis < 3; ++axis) {
    const double count = octree.workspace().sizes()[axis] / size;
    space.grid.counts[static_cast<std::size_t>(axis)] = std::max(1, static_cast<int>(std::ceil(count - 1e-9)));
  }
  space.kinds.assign(space.grid.size(), CellKind::Free);
  octree.forEachLeaf([&](const Octree::Leaf& leaf) {
    if (leaf.kind == CellKind::Free) return;
    // The cells of the grid that the leaf covers, or the one that contains the leaf.
    std::array<int, 3> first{};
    std::array<int, 3> last{};
    for (std::size_t a = 0; a < 3; ++a) {
      if (leaf.cell.level >= level) {
        first[a] = last[a] = static_cast<int>(leaf.cell.index[a] >> static_cast<unsigned>(leaf.cell.level - level));
      } else {
        const unsigned shift = static_cast<unsigned>(level - leaf.cell.level);
        first[a] = static_cast<int>(leaf.cell.index[a] << shift);
        last[a] = first[a] + (1 << shift) - 1;
      }
      last[a] = std::min(last[a], space.grid.counts[a] - 1);
    }
    for (int x = first[0]; x <= last[0]; ++x) {
      for (int y = first[1]; y <= last[1]; ++y) {
        for (int z = first[2]; z <= last[2]; ++z) {
          CellKind& kind = space.kinds[space.grid.at(x, y, z)];
          kind = std::max(kind, leaf.kind);
        }
      }
    }
  });
  return space;
}

namespace {

/// One pass along a line: lower envelope of parabolas rooted at squared distances f (cell units). There is a wall one
/// cell beyond both ends.
class LineTransform {
 public:
  explicit LineTransform(std::size_t longest) : f_(longest + 2), hull_(longest + 2), from_(longest + 3) {}

  void run(std::vector<double>& values, std::size_t start, std::size_t stride, int count) {
    const int n = count + 2;
    f_[0] = f_[static_cast<std::size_t>(n) - 1] = 0.0;
    for (int i = 0; i < count; ++i) {
      f_[static_cast<std::size_t>(i) + 1] = values[start + static_cast<std::size_t>(i) * stride];
    }
    envelope(n);
    std::size_t k = 0;
    for (int i = 0; i < count; ++i) {
      const double x = i + 1;
      while (from_[k + 1] < x) ++k;
      const double offset = x - hull_[k];
      values[start + static_cast<std::size_t>(i) * stride] = offset * offset + f_[static_cast<std::size_t>(hull_[k])];
    }
  }

 private:
  void envelope(int n) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    std::size_t k = 0;
    hull_[0] = 0;
    from_[0] = -kFar;
    from_[1] = kFar;
    for (int q = 1; q < n; ++q) {
      if (std::isinf(f_[static_cast<std::size_t>(q)])) continue;
      double crossing = meeting(hull_[k], q);
      while (crossing <= from_[k]) crossing = meeting(hull_[--k], q);
      hull_[++k] = q;
      from_[k] = crossing;
      from_[k + 1] = kFar;
    }
  }

  double meeting(int p, int q) const {
    const auto height = [&](int i) { return f_[static_cast<std::size_t>(i)] + static_cast<double>(i) * i; };
    return (height(q) - height(p)) / (2.0 * (q - p));
  }

  std::vector<double> f_;
  std::vector<int> hull_;
  std::vector<double> from_;
};

}  // namespace

std::vector<double> distanceTransform(const FreeSpace& space, bool mobileToo, const StopToken& stop) {
  const CellGrid& grid = space.grid;
  std::vector<double> distance(grid.size());
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    const bool open = mobileToo ? space.kinds[cell] == CellKind::Free : space.open(cell);
    distance[cell] = open ? std::numeric_limits<double>::infinity() : 0.0;
  }
  LineTransform line(static_cast<std::size_t>(*std::max_element(grid.counts.begin(), grid.counts.end())));
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t stride = grid.stride(axis);
    const auto count = grid.counts[static_cast<std::size_t>(axis)];
    const std::size_t slab = stride * static_cast<std::size_t>(count);  // cells that the lines of one slab fill
    for (std::size_t first = 0; first < grid.size(); first += slab) {
      if (stop.stopRequested()) return distance;
      for (std::size_t cell = first; cell < first + stride; ++cell) line.run(distance, cell, stride, count);
    }
  }
  for (double& value : distance) value = std::sqrt(value) * grid.cellSize();
  return distance;
}

}  // namespace glissade
