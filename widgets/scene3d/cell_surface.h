#pragma once

#include <array>
#include <functional>
#include <vector>

#include "engine/environment/free_space.h"

namespace glissade {

/// A rectangle of cell faces with one normal.
struct CellFace {
  std::array<Vector3, 4> corners;
  Vector3 normal;
};

/// Where `inside` changes to something else between neighbouring cells, or the grid ends: the faces
/// of the cells in `cells` (ascending), neighbours in a plane merged into rectangles. `across`
/// decides for a face of a cell in the set whether it is drawn, given the cell beyond (or nothing).
std::vector<CellFace> surfaceOf(const CellGrid& grid, const std::vector<std::size_t>& cells,
                                const std::function<bool(std::size_t cell, std::optional<std::size_t> beyond)>& across);

/// The outer surface of a set of cells.
std::vector<CellFace> outerSurface(const CellGrid& grid, const std::vector<std::size_t>& cells);

}  // namespace glissade
