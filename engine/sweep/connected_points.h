#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/sweep/kuhn_division.h"
#include "engine/sweep/lattice.h"

namespace glissade {

/// Calls visit(neighbour, length) for the other ends of the edges of Kuhn's division at a point of a lattice; the
/// length in spacings.
template <class Visit>
void forEachKuhnNeighbour(const Lattice& lattice, std::size_t point, const Visit& visit) {
  const auto at = lattice.coordinates(point);
  for (int corner = 1; corner <= kKuhnDirections; ++corner) {
    const std::array<int, 3> step{corner >> 2, corner >> 1 & 1, corner & 1};
    const double length = std::sqrt(static_cast<double>(step[0] + step[1] + step[2]));
    bool hasNext = true;
    bool hasPrevious = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      hasNext = hasNext && at[axis] + step[axis] < lattice.counts[axis];
      hasPrevious = hasPrevious && at[axis] >= step[axis];
    }
    const std::size_t stride = lattice.at(step[0], step[1], step[2]);
    if (hasNext) visit(point + stride, length);
    if (hasPrevious) visit(point - stride, length);
  }
}

/// The points, as true, that are connected with the first point of the lattice along edges that `joins` accepts:
/// joins(point, neighbour, length in spacings). Precondition: less than 2^32 points.
template <class Joins>
std::vector<bool> connectedWithTheRim(const Lattice& lattice, const Joins& joins) {
  std::vector<bool> connected(lattice.size(), false);
  std::vector<std::uint32_t> open{0};
  connected[0] = true;
  while (!open.empty()) {
    const std::size_t point = open.back();
    open.pop_back();
    forEachKuhnNeighbour(lattice, point, [&](std::size_t next, double length) {
      if (connected[next] || !joins(point, next, length)) return;
      connected[next] = true;
      open.push_back(static_cast<std::uint32_t>(next));
    });
  }
  return connected;
}

}  // namespace glissade
