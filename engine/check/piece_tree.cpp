#include "engine/check/piece_tree.h"

#include <algorithm>

namespace glissade::check {
namespace {

Vector3 centroidOf(const PieceTree::Triangle& triangle) {
  return (triangle.corners[0] + triangle.corners[1] + triangle.corners[2]) / 3.0;
}

Vector3 unitOrZero(const Vector3& normal) {
  const double length = normal.norm();
  return length > 0.0 ? Vector3(normal / length) : Vector3::Zero();
}

}  // namespace

PieceTree::PieceTree(const std::vector<Corners>& triangles) {
  for (const Corners& corners : triangles) {
    triangles_.push_back({corners, unitOrZero((corners[1] - corners[0]).cross(corners[2] - corners[0]))});
  }
  if (triangles_.empty()) return;
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) order_.push_back(t);
  nodes_.emplace_back();
  build(0, 0, static_cast<std::uint32_t>(order_.size()));
  order_ = {};
}

void PieceTree::build(std::uint32_t node, std::uint32_t first, std::uint32_t last) {
  Box3 box;
  Box3 middles;
  for (std::uint32_t i = first; i < last; ++i) {
    for (const Vector3& corner : triangles_[order_[i]].corners) box.extend(corner);
    middles.extend(centroidOf(triangles_[order_[i]]));
  }
  Node made{box, box.center()};
  for (std::uint32_t i = first; i < last; ++i) {
    for (const Vector3& corner : triangles_[order_[i]].corners) {
      made.radius = std::max(made.radius, (corner - made.middle).norm());
    }
  }
  made.isLeaf = last - first == 1;
  made.first = order_[first];
  if (!made.isLeaf) {
    Eigen::Index axis = 0;
    middles.sizes().maxCoeff(&axis);
    const std::uint32_t middle = first + (last - first) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](std::uint32_t a, std::uint32_t b) {
                       const double one = centroidOf(triangles_[a])[axis];
                       const double other = centroidOf(triangles_[b])[axis];
                       return one != other ? one < other : a < b;
                     });
    made.first = static_cast<std::uint32_t>(nodes_.size());
    made.second = made.first + 1;
    nodes_.resize(nodes_.size() + 2);
    build(made.first, first, middle);
    build(made.second, middle, last);
  }
  nodes_[node] = made;
}

}  // namespace glissade::check
