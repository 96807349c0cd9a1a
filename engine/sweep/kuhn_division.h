#pragma once

#include <array>

namespace glissade {

/// Kuhn's division of a lattice's cells: six tetrahedra about the diagonal of each cell, which match those of the
/// neighbours. A corner of a cell is three bits (x: 4, y: 2, z: 1).
using TetrahedronCorners = std::array<int, 4>;

/// The tetrahedra of a cell, positively oriented.
inline constexpr std::array<TetrahedronCorners, 6> kKuhnTetrahedra{
    {{0, 4, 6, 7}, {0, 6, 2, 7}, {0, 2, 3, 7}, {0, 3, 1, 7}, {0, 1, 5, 7}, {0, 5, 4, 7}}};

}  // namespace glissade
