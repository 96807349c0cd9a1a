#include "engine/evidence/part_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/geometry/nearest_point.h"

namespace glissade::evidence {
namespace {

/// Least cosine between normals of triangles that face about the same way.
constexpr double kSameWay = 0.94;
/// Largest number of triangles that are tested for convexity.
constexpr std::size_t kFewTriangles = 32;
constexpr double kRounding = 1e-9;  ///< metres

}  // namespace

double longestEdge(const Triangle& triangle) {
  double longest = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    longest = std::max(longest, (triangle[(i + 1) % 3] - triangle[i]).squaredNorm());
  }
  return std::sqrt(longest);
}

PartCells::PartCells(const Triangle& part, const std::vector<Triangle>& triangles, const std::vector<Vector3>& normals,
                     const std::vector<std::uint32_t>& near)
    : triangles_(triangles), normals_(normals) {
  open_.push(cellOf(part, near));
}

PartCell PartCells::take() {
  PartCell cell = open_.top();
  open_.pop();
  return cell;
}

/// Divides the cell across its longest edge.
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
  cell.bound = std::min(cell.bound, belowPlanes(cell));
  return cell;
}

/// Upper bound on the depth of points of the cell by the planes of the triangles; infinity if they give none.
double PartCells::belowPlanes(const PartCell& cell) const {
  const Vector3& first = normals_[cell.near.front()];
  const bool sameWay =
      std::all_of(cell.near.begin(), cell.near.end(), [&](auto t) { return normals_[t].dot(first) >= kSameWay; });
  const bool convex = isConvex(cell.near);
  if (!sameWay && !convex) return std::numeric_limits<double>::infinity();
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (const std::uint32_t t : cell.near) {
    double below = 0.0;
    for (const Vector3& corner : cell.corners) below = std::max(below, heightBelow(t, corner));
    least = std::min(least, below);
    most = std::max(most, below);
  }
  return convex ? least : most;
}

/// True if none of a few triangles is above the plane of another one.
bool PartCells::isConvex(const std::vector<std::uint32_t>& near) const {
  if (near.size() > kFewTriangles) return false;
  return std::all_of(near.begin(), near.end(), [&](std::uint32_t t) {
    return std::all_of(near.begin(), near.end(), [&](std::uint32_t other) {
      const Triangle& corners = triangles_[other];
      return std::all_of(corners.begin(), corners.end(),
                         [&](const Vector3& corner) { return heightBelow(t, corner) >= -kRounding; });
    });
  });
}

}  // namespace glissade::evidence
