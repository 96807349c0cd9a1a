#include "engine/check/part_cells.h"

#include <algorithm>
#include <cmath>

#include "engine/geometry/nearest_point.h"

namespace glissade::check {

double longestEdge(const Triangle& triangle) {
  double longest = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    longest = std::max(longest, (triangle[(i + 1) % 3] - triangle[i]).squaredNorm());
  }
  return std::sqrt(longest);
}

PartCells::PartCells(const Triangle& part, const std::vector<Triangle>& triangles,
                     const std::vector<std::uint32_t>& near)
    : triangles_(triangles) {
  open_.push(cellOf(part, near));
}

PartCell PartCells::take() {
  PartCell cell = open_.top();
  open_.pop();
  return cell;
}

/// Across the longest edge.
void PartCells::halve(const PartCell& cell) {
  std::size_t longest = 0;
  const auto edge = [&](std::size_t i) { return (cell.corners[(i + 1) % 3] - cell.corners[i]).squaredNorm(); };
  for (std::size_t i = 1; i < 3; ++i) {
    if (edge(i) > edge(longest)) longest = i;
  }
  const Vector3& a = cell.corners[longest];
  const Vector3& b = cell.corners[(longest + 1) % 3];
  const Vector3& apex = cell.corners[(longest + 2) % 3];
  const Vector3 middle = 0.5 * (a + b);
  for (const Triangle& half : {Triangle{a, middle, apex}, Triangle{middle, b, apex}}) {
    open_.push(cellOf(half, cell.near));
  }
}

PartCell PartCells::cellOf(const Triangle& corners, const std::vector<std::uint32_t>& near) const {
  PartCell cell{corners, {}, (corners[0] + corners[1] + corners[2]) / 3.0, 0.0};
  for (const Vector3& corner : corners) cell.radius = std::max(cell.radius, (corner - cell.middle).norm());
  std::vector<double> distances;
  const auto distance = [&](const Vector3& p, std::uint32_t t) { return (nearestPoint(triangles_[t], p) - p).norm(); };
  for (const std::uint32_t t : near) distances.push_back(distance(cell.middle, t));
  const auto nearest = std::min_element(distances.begin(), distances.end());
  if (nearest == distances.end()) return cell;
  cell.distance = *nearest;
  const std::uint32_t number = near[static_cast<std::size_t>(nearest - distances.begin())];
  for (const Vector3& corner : corners) cell.bound = std::max(cell.bound, distance(corner, number));
  cell.bound = std::min(cell.bound, cell.distance + cell.radius);
  for (std::size_t i = 0; i < near.size(); ++i) {
    if (distances[i] <= cell.distance + 2.0 * cell.radius) cell.near.push_back(near[i]);
  }
  return cell;
}

}  // namespace glissade::check
