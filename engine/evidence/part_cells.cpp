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
  PartCell whole;
  whole.near = near;
  whole.convex = isConvex(near);
  push(cellOf(part, whole));
}

PartCell PartCells::take() {
  std::pop_heap(open_.begin(), open_.end(), isLess);
  PartCell cell = std::move(open_.back());
  open_.pop_back();
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
    push(cellOf(half, cell));
  }
}

void PartCells::push(PartCell cell) {
  open_.push_back(std::move(cell));
  std::push_heap(open_.begin(), open_.end(), isLess);
}

PartCell PartCells::cellOf(const Triangle& corners, const PartCell& parent) const {
  const std::vector<std::uint32_t>& near = parent.near;
  PartCell cell;
  cell.corners = corners;
  cell.middle = (corners[0] + corners[1] + corners[2]) / 3.0;
  for (const Vector3& corner : corners) cell.radius = std::max(cell.radius, (corner - cell.middle).norm());
  if (near.empty()) return cell;
  std::vector<Vector3> away;  // from each triangle's nearest point to the middle
  for (const std::uint32_t t : near) away.push_back(cell.middle - nearestPoint(triangles_[t], cell.middle));
  const auto isShorter = [](const Vector3& a, const Vector3& b) { return a.squaredNorm() < b.squaredNorm(); };
  const auto nearest = std::min_element(away.begin(), away.end(), isShorter);
  cell.distance = nearest->norm();
  const Triangle& triangle = triangles_[near[static_cast<std::size_t>(nearest - away.begin())]];
  std::array<double, 3> atCorners{};
  for (std::size_t i = 0; i < 3; ++i) atCorners[i] = (corners[i] - nearestPoint(triangle, corners[i])).norm();
  cell.bound = std::min(*std::max_element(atCorners.begin(), atCorners.end()), cell.distance + cell.radius);
  for (std::size_t i = 0; i < near.size(); ++i) {
    if (canBeNearest(away[i], cell, atCorners)) cell.near.push_back(near[i]);
  }
  // A subset of a convex set is convex.
  cell.convex = parent.convex || (cell.near.size() < near.size() && isConvex(cell.near));
  cell.bound = std::min(cell.bound, belowPlanes(cell));
  return cell;
}

/// True if a triangle can be nearest to a point of the cell. `away`: from its nearest point to the middle. `atCorners`:
/// the corners' distances from the triangle that is nearest to the middle. Both distances are convex functions: that
/// from the triangle is no less than its tangent at the middle, that from the nearest one no more than the
/// interpolation between the corners.
bool PartCells::canBeNearest(const Vector3& away, const PartCell& cell, const std::array<double, 3>& atCorners) {
  const double distance = away.norm();
  const Vector3 slope = distance > 0.0 ? Vector3(away / distance) : Vector3::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    if (distance + slope.dot(cell.corners[i] - cell.middle) <= atCorners[i] + kRounding) return true;
  }
  return false;
}

/// Upper bound on the depth of points of the cell by the planes of the triangles; infinity if they give none.
double PartCells::belowPlanes(const PartCell& cell) const {
  const Vector3& first = normals_[cell.near.front()];
  const bool sameWay =
      std::all_of(cell.near.begin(), cell.near.end(), [&](auto t) { return normals_[t].dot(first) >= kSameWay; });
  if (!sameWay && !cell.convex) return std::numeric_limits<double>::infinity();
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (const std::uint32_t t : cell.near) {
    double below = 0.0;
    for (const Vector3& corner : cell.corners) below = std::max(below, heightBelow(t, corner));
    least = std::min(least, below);
    most = std::max(most, below);
  }
  return cell.convex ? least : most;
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
