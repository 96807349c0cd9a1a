#include "engine/geometry/ray_tree.h"

#include <algorithm>
#include <array>
#include <limits>

namespace glissade {
namespace {

constexpr std::uint32_t kRayLeafSize = 4;
/// Boxes are this share of their diagonal wider, because triangles are hit with some rounding.
constexpr double kMargin = 1e-9;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// (T. Moller, B. Trumbore, "Fast, minimum storage ray/triangle intersection", 1997)
double hit(const Vector3& origin, const Vector3& direction, const Triangle& triangle) {
  const Vector3 e1 = triangle[1] - triangle[0];
  const Vector3 e2 = triangle[2] - triangle[0];
  const Vector3 p = direction.cross(e2);
  const double determinant = e1.dot(p);
  if (determinant == 0.0) return kInfinity;
  const Vector3 s = origin - triangle[0];
  const double u = s.dot(p) / determinant;
  const Vector3 q = s.cross(e1);
  const double v = direction.dot(q) / determinant;
  return u < 0.0 || v < 0.0 || u + v > 1.0 ? kInfinity : e2.dot(q) / determinant;
}

/// The ray is in the box at some t of [0, most].
bool mayHit(const Vector3& origin, const Vector3& direction, const Box3& box, double most) {
  double from = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = box.min()[axis] - origin[axis];
    const double high = box.max()[axis] - origin[axis];
    if (direction[axis] == 0.0) {
      if (low > 0.0 || high < 0.0) return false;
      continue;
    }
    const double a = low / direction[axis];
    const double b = high / direction[axis];
    from = std::max(from, std::min(a, b));
    most = std::min(most, std::max(a, b));
  }
  return from <= most;
}

}  // namespace

RayTree::RayTree(std::vector<Triangle> triangles) : triangles_(std::move(triangles)) {
  if (!triangles_.empty()) build(0, static_cast<std::uint32_t>(triangles_.size()));
}

/// A node for a run of triangles and all below it: halves by their middles along the widest axis.
void RayTree::build(std::uint32_t first, std::uint32_t last) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Box3 box;
  Box3 middles;
  for (std::uint32_t i = first; i < last; ++i) {
    for (const Vector3& corner : triangles_[i]) box.extend(corner);
    middles.extend(triangles_[i][0] + triangles_[i][1] + triangles_[i][2]);
  }
  const Vector3 margin = Vector3::Constant(kMargin * box.diagonal().norm());
  nodes_[index].box = Box3(box.min() - margin, box.max() + margin);
  if (last - first <= kRayLeafSize) {
    nodes_[index].first = first;
    nodes_[index].count = last - first;
    return;
  }
  int axis = 0;
  middles.sizes().maxCoeff(&axis);
  const std::uint32_t middle = first + (last - first) / 2;
  const auto at = [&](std::uint32_t i) { return triangles_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(middle), at(last), [axis](const Triangle& a, const Triangle& b) {
    return a[0][axis] + a[1][axis] + a[2][axis] < b[0][axis] + b[1][axis] + b[2][axis];
  });
  build(first, middle);
  nodes_[index].first = static_cast<std::uint32_t>(nodes_.size());
  build(middle, last);
}

double RayTree::firstHit(const Vector3& origin, const Vector3& direction, double after) const {
  double least = kInfinity;
  std::array<std::uint32_t, 64> open;  // halving leaves no more levels than an index has bits
  std::size_t count = 0;
  if (!nodes_.empty()) open[count++] = 0;
  while (count > 0) {
    const std::uint32_t index = open[--count];
    const Node& node = nodes_[index];
    if (!mayHit(origin, direction, node.box, least)) continue;
    if (node.count == 0) {
      open[count++] = node.first;
      open[count++] = index + 1;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const double t = hit(origin, direction, triangles_[i]);
      if (t > after) least = std::min(least, t);
    }
  }
  return least;
}

}  // namespace glissade
