#include "engine/geometry/triangle_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "engine/base/in_threads.h"

namespace glissade {
namespace {

constexpr std::uint32_t kMostInALeaf = 4;
/// Relative widening of boxes for rays, because the hit of a triangle is rounded.
constexpr double kRayMargin = 1e-9;
/// Factor for the distances of boxes. The distance of a triangle may round to less than that of its box, by much less
/// than this.
constexpr double kRoundedDown = 1.0 - 1e-12;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<Triangle> trianglesOf(const TriangleMesh& mesh) {
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    triangles.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
  }
  return triangles;
}

bool areNear(const Box3& a, const Box3& b, double distance) {
  return ((a.min().array() - distance <= b.max().array()) && (b.min().array() - distance <= a.max().array())).all();
}

/// Hit by T. Moller, B. Trumbore, "Fast, minimum storage ray/triangle intersection", 1997.
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

/// True if the ray meets the widened box at some t in [0, most].
bool mayHit(const Vector3& origin, const Vector3& direction, const Box3& box, double most) {
  double from = 0.0;
  const double margin = kRayMargin * box.sizes().sum();
  for (int axis = 0; axis < 3; ++axis) {
    const double low = box.min()[axis] - margin - origin[axis];
    const double high = box.max()[axis] + margin - origin[axis];
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

TriangleTree::TriangleTree(const TriangleMesh& mesh) : TriangleTree(trianglesOf(mesh)) {}

TriangleTree::TriangleTree(std::vector<Triangle> triangles) : triangles_(std::move(triangles)) {
  for (const Triangle& triangle : triangles_) {
    Box3 box;
    for (const Vector3& corner : triangle) box.extend(corner);
    boxes_.push_back(box);
    box_.extend(box);
  }
  order_.resize(triangles_.size());
  std::iota(order_.begin(), order_.end(), 0U);
  if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()));
}

/// Builds a node for a range of triangles and all nodes below it, by halving at their middles along the widest axis.
void TriangleTree::build(std::uint32_t first, std::uint32_t last) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Box3 middles;
  for (std::uint32_t i = first; i < last; ++i) {
    nodes_[index].box.extend(boxes_[order_[i]]);
    middles.extend(boxes_[order_[i]].center());
  }
  nodes_[index].size = nodes_[index].box.diagonal().norm();
  if (last - first <= kMostInALeaf) {
    nodes_[index].first = first;
    nodes_[index].count = last - first;
    return;
  }
  int axis = 0;
  middles.sizes().maxCoeff(&axis);
  const std::uint32_t middle = first + (last - first) / 2;
  const auto at = [&](std::uint32_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(middle), at(last), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(boxes_[a].center()[axis], a) < std::pair(boxes_[b].center()[axis], b);
  });
  build(first, middle);
  nodes_[index].first = static_cast<std::uint32_t>(nodes_.size());
  build(middle, last);
}

/// The nearest triangle by squared distances of boxes and triangles. The boxes' distances, which may be too small,
/// exclude their contents.
template <class ToBox, class ToTriangle>
TriangleTree::Nearest TriangleTree::nearestBy(const ToBox& toBox, const ToTriangle& toTriangle, double limit,
                                              double enough) const {
  struct Open {
    std::uint32_t node;
    double squared;  ///< squared distance of its box
  };
  double least = limit * limit;
  const double enoughSquared = enough * enough;
  std::uint32_t found = 0;
  std::array<Open, 64> open;  // depth limit: halving gives no more levels than an index has bits
  std::size_t count = 0;
  if (!nodes_.empty()) open[count++] = {0, toBox(nodes_[0].box)};
  while (count > 0) {
    const Open next = open[--count];
    const Node& node = nodes_[next.node];
    if (next.squared >= least) continue;
    if (node.count == 0) {
      const Open one{next.node + 1, toBox(nodes_[next.node + 1].box)};
      const Open other{node.first, toBox(nodes_[node.first].box)};
      const bool oneIsNearer = one.squared < other.squared;
      open[count++] = oneIsNearer ? other : one;
      open[count++] = oneIsNearer ? one : other;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (kRoundedDown * toBox(boxes_[order_[i]]) >= least) continue;
      const double squared = toTriangle(triangles_[order_[i]]);
      if (squared >= least) continue;
      least = squared;
      found = order_[i];
      if (least <= enoughSquared) return {std::sqrt(least), found};
    }
  }
  return {std::sqrt(least), found};
}

TriangleTree::Nearest TriangleTree::nearest(const Vector3& p, double limit, double enough) const {
  return nearestBy([&](const Box3& box) { return box.squaredExteriorDistance(p); },
                   [&](const Triangle& triangle) { return (nearestPoint(triangle, p) - p).squaredNorm(); }, limit,
                   enough);
}

double TriangleTree::distanceToSegment(const Vector3& a, const Vector3& b, double limit, double enough) const {
  const Vector3 middle = 0.5 * (a + b);
  const double half = 0.5 * (b - a).norm();
  const Box3 around(a.cwiseMin(b), a.cwiseMax(b));
  const auto toBox = [&](const Box3& box) {
    const double fromMiddle = std::max(0.0, std::sqrt(box.squaredExteriorDistance(middle)) - half);
    return std::max(fromMiddle * fromMiddle, box.squaredExteriorDistance(around));
  };
  return nearestBy(
             toBox, [&](const Triangle& triangle) { return squaredSegmentDistance(a, b, triangle); }, limit, enough)
      .distance;
}

/// Calls `take` for every triangle of the leaves whose boxes, and the boxes around them, `enters` accepts, until `take`
/// returns false.
template <class Enters, class Take>
void TriangleTree::walk(const Enters& enters, const Take& take) const {
  std::array<std::uint32_t, 64> open;  // depth limit: halving gives no more levels than an index has bits
  std::size_t count = 0;
  if (!nodes_.empty()) open[count++] = 0;
  while (count > 0) {
    const std::uint32_t index = open[--count];
    const Node& node = nodes_[index];
    if (!enters(node.box)) continue;
    if (node.count == 0) {
      open[count++] = node.first;
      open[count++] = index + 1;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (!take(order_[i])) return;
    }
  }
}

void TriangleTree::visit(const Box3& box, const std::function<bool(std::uint32_t)>& take) const {
  walk([&](const Box3& node) { return node.intersects(box); },
       [&](std::uint32_t triangle) { return !boxes_[triangle].intersects(box) || take(triangle); });
}

double TriangleTree::firstHit(const Vector3& origin, const Vector3& direction, double after) const {
  double least = kInfinity;
  walk([&](const Box3& node) { return mayHit(origin, direction, node, least); },
       [&](std::uint32_t triangle) {
         const double t = hit(origin, direction, triangles_[triangle]);
         if (t > after) least = std::min(least, t);
         return true;
       });
  return least;
}

/// Adds the pairs below this one to `open`, or calls `take` for its triangles. False: `take` returned false.
template <class Take>
bool TriangleTree::visitPair(const TriangleTree& other, double distance, const NodePair& pair,
                             std::vector<NodePair>& open, const Take& take) const {
  const auto [a, b] = pair;
  const Node& mine = nodes_[a];
  const Node& theirs = other.nodes_[b];
  if (!areNear(mine.box, theirs.box, distance)) return true;
  if (mine.count > 0 && theirs.count > 0) {
    for (std::uint32_t i = mine.first; i < mine.first + mine.count; ++i) {
      for (std::uint32_t k = theirs.first; k < theirs.first + theirs.count; ++k) {
        const bool near = areNear(boxes_[order_[i]], other.boxes_[other.order_[k]], distance);
        if (near && !take(order_[i], other.order_[k])) return false;
      }
    }
    return true;
  }
  const bool openMine = theirs.count > 0 || (mine.count == 0 && mine.size >= theirs.size);
  if (openMine) {
    open.push_back({mine.first, b});
    open.push_back({a + 1, b});
  } else {
    open.push_back({a, theirs.first});
    open.push_back({a, b + 1});
  }
  return true;
}

void TriangleTree::visitPairs(const TriangleTree& other, double distance,
                              const std::function<bool(std::uint32_t, std::uint32_t)>& take) const {
  if (nodes_.empty() || other.nodes_.empty()) return;
  std::vector<NodePair> open{{0, 0}};
  while (!open.empty()) {
    const NodePair next = open.back();
    open.pop_back();
    if (!visitPair(other, distance, next, open, take)) return;
  }
}

void TriangleTree::visitAllPairs(const TriangleTree& other, double distance,
                                 const std::function<void(std::uint32_t, std::uint32_t)>& take) const {
  constexpr std::size_t kPieces = 256;
  constexpr std::size_t kMostOfOneThread = 4096;
  const auto takeAll = [&take](std::uint32_t i, std::uint32_t k) {
    take(i, k);
    return true;
  };
  if (triangles_.size() <= kMostOfOneThread || other.nodes_.empty()) {
    visitPairs(other, distance, takeAll);
    return;
  }
  std::vector<NodePair> pieces{{0, 0}};
  while (!pieces.empty() && pieces.size() < kPieces) {
    std::vector<NodePair> below;
    for (const NodePair& pair : pieces) visitPair(other, distance, pair, below, takeAll);
    pieces = std::move(below);
  }
  forEachInThreads(pieces.size(), 1, [&](std::size_t piece) {
    std::vector<NodePair> open{pieces[piece]};
    while (!open.empty()) {
      const NodePair next = open.back();
      open.pop_back();
      visitPair(other, distance, next, open, takeAll);
    }
  });
}

}  // namespace glissade
