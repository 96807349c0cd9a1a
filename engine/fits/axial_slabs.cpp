#include "engine/fits/axial_slabs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "engine/geometry/mesh_volume.h"

namespace glissade {
namespace {

constexpr double kNoSurface = std::numeric_limits<double>::infinity();
constexpr double kAngleStep = 2.0 * std::numbers::pi / kAxialAngles;
/// Offsets that usually avoid the directions and heights of corners.
constexpr double kAngleOffset = 0.3719 * kAngleStep;
constexpr double kHeightShare = 0.4871;
/// Corners within this share of the whole length count as one height.
constexpr double kOneHeight = 1.0 / 400.0;
/// Limit of the heights of corners; beyond it slabs are evenly spaced.
constexpr std::size_t kMostHeights = 64;
constexpr int kEvenSlabs = 96;
/// Largest length of a slab, as a share of the whole length.
constexpr double kLongestSlab = 1.0 / 16.0;

using Corners = std::vector<Triangle>;  ///< x, y about the axis, z along it

Corners cornersAbout(const TriangleTree& tree, const AxisLine& axis, const AxialReach& reach) {
  const Vector3 u = axis.direction.unitOrthogonal();
  const Vector3 v = axis.direction.cross(u);
  Box3 box(Vector3(axis.point + reach.low * axis.direction));
  box.extend(Vector3(axis.point + reach.high * axis.direction));
  box.min().array() -= reach.radius;
  box.max().array() += reach.radius;
  Corners corners;
  tree.visit(box, [&](std::uint32_t t) {
    Triangle& local = corners.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 way = tree.triangles()[t][i] - axis.point;
      local[i] = {way.dot(u), way.dot(v), way.dot(axis.direction)};
    }
    return true;
  });
  return corners;
}

std::vector<double> evenHeights(double low, double high, int slabs) {
  std::vector<double> heights;
  for (int i = 0; i <= slabs; ++i) heights.push_back(low + (high - low) * i / slabs);
  return heights;
}

/// Heights of the corners, with heights added so that no slab is too long.
std::vector<double> slabHeights(const Corners& corners, const AxialReach& reach) {
  const double length = reach.high - reach.low;
  std::vector<double> found{reach.low, reach.high};
  for (const Triangle& triangle : corners) {
    for (const Vector3& p : triangle) {
      if (p.z() > reach.low && p.z() < reach.high && std::hypot(p.x(), p.y()) <= reach.radius) found.push_back(p.z());
    }
  }
  std::sort(found.begin(), found.end());
  std::vector<double> distinct;
  for (const double height : found) {
    if (distinct.empty() || height - distinct.back() > kOneHeight * length) distinct.push_back(height);
  }
  if (distinct.size() > kMostHeights) return evenHeights(reach.low, reach.high, kEvenSlabs);
  if (distinct.size() < 2) distinct = {reach.low, reach.high};
  distinct.back() = reach.high;
  std::vector<double> heights{distinct.front()};
  for (std::size_t i = 1; i < distinct.size(); ++i) {
    const double gap = distinct[i] - distinct[i - 1];
    const int parts = std::max(1, static_cast<int>(std::ceil(gap / (kLongestSlab * length) - 1e-9)));
    for (int part = 1; part <= parts; ++part) heights.push_back(distinct[i - 1] + gap * part / parts);
  }
  return heights;
}

/// The intersection of a triangle and the plane at a height.
struct CutEdge {
  Eigen::Vector2d from;
  Eigen::Vector2d to;
};

CutEdge cutAt(const Triangle& triangle, double height) {
  std::array<Eigen::Vector2d, 2> ends{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3 && count < 2; ++i) {
    const Vector3& a = triangle[i];
    const Vector3& b = triangle[(i + 1) % 3];
    if ((a.z() < height) == (b.z() < height)) continue;
    const double t = (height - a.z()) / (b.z() - a.z());
    ends[count++] = a.head<2>() + t * (b - a).head<2>();
  }
  return {ends[0], ends[1]};
}

double crossOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Number of directions in which the nearest surface leads out of the body, minus those in which it leads into it.
using Votes = std::vector<std::array<int, kAxialAngles>>;

void noteEdge(CutEdge edge, bool outwards, double reach, AxialSlab& slab, std::array<int, kAxialAngles>& votes) {
  double turn = std::atan2(crossOf(edge.from, edge.to), edge.from.dot(edge.to));
  if (turn < 0.0) {
    std::swap(edge.from, edge.to);
    turn = -turn;
  }
  const double start = std::atan2(edge.from.y(), edge.from.x());
  const Eigen::Vector2d along = edge.to - edge.from;
  const auto first = static_cast<int>(std::ceil((start - kAngleOffset) / kAngleStep));
  for (int k = first; kAngleOffset + k * kAngleStep <= start + turn; ++k) {
    const double angle = kAngleOffset + k * kAngleStep;
    const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
    const double radius = crossOf(edge.from, along) / crossOf(direction, along);
    if (!(radius > 0.0 && radius <= reach)) continue;
    const auto at = static_cast<std::size_t>((k % kAxialAngles + kAxialAngles) % kAxialAngles);
    if (radius < slab.nearest[at]) {
      slab.nearest[at] = radius;
      votes[at] = outwards ? 1 : -1;
    }
    slab.farthest[at] = std::max(slab.farthest[at], radius);
  }
}

double heightIn(const AxialSlab& slab) { return slab.low + kHeightShare * slab.length(); }

void noteTriangle(const Triangle& triangle, double sense, double reach, std::vector<AxialSlab>& slabs, Votes& votes) {
  const double low = std::min({triangle[0].z(), triangle[1].z(), triangle[2].z()});
  const double high = std::max({triangle[0].z(), triangle[1].z(), triangle[2].z()});
  auto slab = std::lower_bound(slabs.begin(), slabs.end(), low,
                               [](const AxialSlab& one, double height) { return heightIn(one) < height; });
  const Vector3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  for (; slab != slabs.end() && heightIn(*slab) < high; ++slab) {
    const CutEdge edge = cutAt(triangle, heightIn(*slab));
    const bool outwards = sense * normal.head<2>().dot(edge.from + edge.to) > 0.0;
    noteEdge(edge, outwards, reach, *slab, votes[static_cast<std::size_t>(slab - slabs.begin())]);
  }
}

}  // namespace

AxisLine transformed(const AxisLine& axis_B, const Pose& X_WB) {
  return {X_WB * axis_B.point, (X_WB.orientation * axis_B.direction).normalized()};
}

double AxialSlab::surroundedShare() const {
  const auto count = std::count_if(nearest.begin(), nearest.end(), [](double r) { return r < kNoSurface; });
  return static_cast<double>(count) / static_cast<double>(nearest.size());
}

double AxialSlab::nearestAt(double share) const {
  std::vector<double> radii;
  for (const double radius : nearest) {
    if (radius < kNoSurface) radii.push_back(radius);
  }
  if (radii.empty()) return kNoSurface;
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(radii.size() - 1));
  std::nth_element(radii.begin(), radii.begin() + at, radii.end());
  return radii[static_cast<std::size_t>(at)];
}

double AxialSlab::outerMost() const { return *std::max_element(farthest.begin(), farthest.end()); }

double AxialSlab::outerLeast() const {
  double least = outerMost();
  for (const double radius : farthest) {
    if (radius > 0.0) least = std::min(least, radius);
  }
  return least;
}

AxialMesh::AxialMesh(const TriangleMesh& mesh) : tree_(mesh), sense_(signedVolume(mesh) < 0.0 ? -1.0 : 1.0) {}

std::vector<AxialSlab> AxialMesh::slabsAbout(const AxisLine& axis, const AxialReach& reach) const {
  const Corners corners = cornersAbout(tree_, axis, reach);
  const std::vector<double> heights = slabHeights(corners, reach);
  std::vector<AxialSlab> slabs;
  for (std::size_t i = 1; i < heights.size(); ++i) {
    AxialSlab& slab = slabs.emplace_back();
    slab.low = heights[i - 1];
    slab.high = heights[i];
    slab.nearest.assign(kAxialAngles, kNoSurface);
    slab.farthest.assign(kAxialAngles, 0.0);
  }
  Votes votes(slabs.size(), std::array<int, kAxialAngles>{});
  for (const Triangle& triangle : corners) noteTriangle(triangle, sense_, reach.radius, slabs, votes);
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    const int vote = std::accumulate(votes[i].begin(), votes[i].end(), 0);
    slabs[i].isSolid =
        slabs[i].surroundedShare() > 0.0 ? vote > 0 : contains(axis.point + heightIn(slabs[i]) * axis.direction);
  }
  return slabs;
}

bool AxialMesh::contains(const Vector3& p) const {
  if (!tree_.box().contains(p)) return false;
  const Vector3 direction = Vector3(0.5377, 0.2831, 0.7942).normalized();
  bool inside = false;
  for (double t = tree_.firstHit(p, direction, 0.0); t < kNoSurface; t = tree_.firstHit(p, direction, t)) {
    inside = !inside;
  }
  return inside;
}

double AxialMesh::filledShare(const AxisLine& axis, double height, double radius) const {
  constexpr int kDirections = 8;
  const Vector3 u = axis.direction.unitOrthogonal();
  const Vector3 v = axis.direction.cross(u);
  int filled = 0;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + kHeightShare) / kDirections;
    filled +=
        contains(axis.point + height * axis.direction + radius * (std::cos(angle) * u + std::sin(angle) * v)) ? 1 : 0;
  }
  return static_cast<double>(filled) / kDirections;
}

}  // namespace glissade
