#include "engine/planning/fine/geometrical_planner.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <unordered_map>

namespace glissade {
namespace {

struct Visit {
  double total;  ///< cost so far plus a lower bound of the remaining cost
  std::size_t cell;
  double spent;

  friend bool operator<(const Visit& a, const Visit& b) {
    return a.total != b.total ? a.total > b.total : a.cell > b.cell;  // order of a queue with the least total on top
  }
};

/// The cell of the area that is nearest to a point.
std::size_t nearestCell(const CellGrid& grid, const std::vector<std::size_t>& area, const Vector3& p) {
  const auto own = grid.find(p);
  if (own && std::binary_search(area.begin(), area.end(), *own)) return *own;
  return *std::min_element(area.begin(), area.end(), [&](std::size_t a, std::size_t b) {
    return (grid.centre(a) - p).squaredNorm() < (grid.centre(b) - p).squaredNorm();
  });
}

}  // namespace

std::vector<std::size_t> findCellPath(const EnvironmentModel& environment, const std::vector<std::size_t>& area,
                                      const std::vector<double>& clearance, const Vector3& from, const Vector3& to,
                                      double objectRadius, const StopToken& stop) {
  const CellGrid& grid = environment.map.grid;
  if (area.empty()) return {};
  const std::size_t start = nearestCell(grid, area, from);
  const std::size_t goal = nearestCell(grid, area, to);
  const Vector3 goalCentre = grid.centre(goal);
  const auto enterable = [&](std::size_t cell) {
    return cell == goal ||
           (environment.space.kinds[cell] == CellKind::Free && std::binary_search(area.begin(), area.end(), cell));
  };
  std::unordered_map<std::size_t, std::pair<double, std::size_t>> reached;  // cost, and the cell before
  std::priority_queue<Visit> open;
  const auto estimate = [&](std::size_t cell) { return (grid.centre(cell) - goalCentre).norm(); };
  reached[start] = {0.0, start};
  open.push({estimate(start), start, 0.0});
  while (!open.empty() && !stop.stopRequested()) {
    const Visit visit = open.top();
    open.pop();
    if (visit.cell == goal) break;
    if (visit.spent > reached[visit.cell].first) continue;
    grid.forEachNeighbour(visit.cell, [&](std::size_t next) {
      if (!enterable(next)) return;
      const double closeness = objectRadius / std::max(clearance[next], 0.5 * grid.cellSize());
      const double spent = visit.spent + grid.cellSize() * (1.0 + closeness * closeness);
      const auto known = reached.find(next);
      if (known != reached.end() && known->second.first <= spent) return;
      reached[next] = {spent, visit.cell};
      open.push({spent + estimate(next), next, spent});
    });
  }
  std::vector<std::size_t> path;
  if (reached.find(goal) == reached.end()) return path;
  for (std::size_t cell = goal; cell != start; cell = reached[cell].second) path.push_back(cell);
  path.push_back(start);
  std::reverse(path.begin(), path.end());
  return path;
}

std::vector<std::size_t> regionAlong(const CellGrid& grid, const std::vector<std::size_t>& path,
                                     const std::vector<std::size_t>& area, double radius) {
  std::unordered_map<std::size_t, int> layerOf;
  std::vector<std::size_t> front;
  for (const std::size_t cell : path) {
    if (layerOf.emplace(cell, 0).second) front.push_back(cell);
  }
  const int layers = static_cast<int>(radius / grid.cellSize());
  for (std::size_t i = 0; i < front.size(); ++i) {
    const int layer = layerOf[front[i]];
    if (layer >= layers) continue;
    grid.forEachNeighbour(front[i], [&](std::size_t next) {
      if (!std::binary_search(area.begin(), area.end(), next)) return;
      if (layerOf.emplace(next, layer + 1).second) front.push_back(next);
    });
  }
  std::sort(front.begin(), front.end());
  return front;
}

}  // namespace glissade
