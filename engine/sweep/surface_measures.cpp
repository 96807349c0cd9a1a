#include "engine/sweep/surface_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glissade {
namespace {

/// The point of the lattice at which the cell with p begins.
std::array<int, 3> cellAt(const Lattice& lattice, const Vector3& p) {
  std::array<int, 3> cell{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<int>(axis);
    const double along = std::floor((p[a] - lattice.origin[a]) / lattice.spacing);
    cell[axis] = std::clamp(static_cast<int>(along), 0, lattice.counts[axis] - 2);
  }
  return cell;
}

}  // namespace

double farthestFromBody(const TriangleMesh& surface_W, const Lattice& lattice, const SweepClearances& clearances) {
  const double reach = static_cast<float>(SweepClearances::kReach * lattice.spacing);
  const double slack = SweepClearances::kSlack * lattice.spacing;
  double farthest = 0.0;
  for (const TriangleIndices& triangle : surface_W.triangles) {
    Vector3 sum = Vector3::Zero();
    for (const std::uint32_t vertex : triangle) sum += surface_W.vertices[vertex];
    const std::array<int, 3> cell = cellAt(lattice, sum / 3.0);
    // Distances from a corner, and so what they bound, are largest at a vertex of the triangle.
    double nearest = std::numeric_limits<double>::infinity();
    for (int corner = 0; corner < 8; ++corner) {
      const std::size_t point = lattice.cornerAt(cell, corner);
      if (clearances.values[point] >= reach) continue;
      const auto [x, y, z] = lattice.coordinates(point);
      double away = 0.0;
      for (const std::uint32_t vertex : triangle) {
        away = std::max(away, (surface_W.vertices[vertex] - lattice.point(x, y, z)).norm());
      }
      nearest = std::min(nearest, clearances.values[point] + slack + away);
    }
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

}  // namespace glissade
