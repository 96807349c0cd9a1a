#pragma once

#include <array>
#include <functional>
#include <vector>

#include "engine/places/free_space.h"

namespace glissade {

/// A rectangle of cell faces with one normal.
struct CellFace {
  std::array<Vector3, 4> corners;
  Vector3 normal;
};

/// The faces of the cells in `cells` (ascending) for which `across` is true; neighbours in a plane are merged into
/// rectangles. `across` gets a cell of the set and the cell beyond its face (nothing at the end of the grid).
std::vector<CellFace> surfaceOf(const CellGrid& grid, const std::vector<std::size_t>& cells,
                                const std::function<bool(std::size_t cell, std::optional<std::size_t> beyond)>& across);

/// The outer surface of a set of cells.
std::vector<CellFace> outerSurface(const CellGrid& grid, const std::vector<std::size_t>& cells);

}  // namespace glissade
