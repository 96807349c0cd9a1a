#pragma once

#include <memory>
#include <vector>

#include "engine/base/random_stream.h"
#include "engine/places/free_space.h"

namespace glissade {

/// An area: a set of cells in which a local planner draws the positions of its configurations (paper
/// 2, section 4.2: the part of the free space that it explores). Immutable, shared by threads.
class SamplingRegion {
 public:
  /// `cells` ascending, not empty.
  SamplingRegion(const CellGrid& grid, std::vector<std::size_t> cells) : grid_(grid), cells_(std::move(cells)) {}

  /// Draws a position uniformly in the area, within the bounds. Cells at the border of the workspace reach beyond it.
  Vector3 sample(RandomStream& stream, const Box3& bounds) const;
  bool contains(const Vector3& p_W) const;

  const CellGrid& grid() const { return grid_; }
  const std::vector<std::size_t>& cells() const { return cells_; }

 private:
  CellGrid grid_;
  std::vector<std::size_t> cells_;
};

using SamplingRegionPtr = std::shared_ptr<const SamplingRegion>;

/// Ascending union of two ascending lists of cells.
std::vector<std::size_t> unionOf(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b);

}  // namespace glissade
