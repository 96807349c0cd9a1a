#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/sweep/lattice.h"

namespace glissade {

/// The edges of Kuhn's division at the points of a lattice.
class KuhnEdges {
 public:
  explicit KuhnEdges(const Lattice& lattice) : lattice_(lattice) {
    for (std::size_t corner = 1; corner < edges_.size(); ++corner) {
      const std::array<int, 3> step{static_cast<int>(corner >> 2), static_cast<int>(corner >> 1 & 1),
                                    static_cast<int>(corner & 1)};
      edges_[corner] = {step, lattice.at(step[0], step[1], step[2]),
                        std::sqrt(static_cast<double>(step[0] + step[1] + step[2]))};
    }
  }

  /// Calls visit(neighbour, length) for the other ends of the edges at a point; the length in spacings.
  template <class Visit>
  void forEachNeighbour(std::size_t point, const Visit& visit) const {
    const auto at = lattice_.coordinates(point);
    bool isInner = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
      isInner = isInner && at[axis] > 0 && at[axis] + 1 < lattice_.counts[axis];
    for (std::size_t corner = 1; corner < edges_.size(); ++corner) {
      const Edge& edge = edges_[corner];
      if (isInner || hasEnd(at, edge.step, 1)) visit(point + edge.stride, edge.length);
      if (isInner || hasEnd(at, edge.step, -1)) visit(point - edge.stride, edge.length);
    }
  }

 private:
  struct Edge {
    std::array<int, 3> step;
    std::size_t stride = 0;
    double length = 0.0;  ///< spacings
  };

  bool hasEnd(const std::array<int, 3>& at, const std::array<int, 3>& step, int sign) const {
    return lattice_.has({at[0] + sign * step[0], at[1] + sign * step[1], at[2] + sign * step[2]});
  }

  const Lattice& lattice_;
  std::array<Edge, 8> edges_{};  ///< by corner of a cell
};

/// The points, as true, that are connected with the first point of the lattice along edges that `joins` accepts:
/// joins(point, neighbour, length in spacings). Precondition: less than 2^32 points. Unfinished after a stop.
template <class Joins>
std::vector<bool> connectedWithTheRim(const Lattice& lattice, const StopToken& stop, const Joins& joins) {
  constexpr std::size_t kPointsBetweenLooks = 4096;
  std::vector<bool> connected(lattice.size(), false);
  const KuhnEdges edges(lattice);
  std::vector<std::uint32_t> open{0};
  connected[0] = true;
  for (std::size_t taken = 0; !open.empty(); ++taken) {
    if (taken % kPointsBetweenLooks == 0 && stop.stopRequested()) break;
    const std::size_t point = open.back();
    open.pop_back();
    edges.forEachNeighbour(point, [&](std::size_t next, double length) {
      if (connected[next] || !joins(point, next, length)) return;
      connected[next] = true;
      open.push_back(static_cast<std::uint32_t>(next));
    });
  }
  return connected;
}

}  // namespace glissade
