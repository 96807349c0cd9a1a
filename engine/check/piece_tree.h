#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/geometry/pose.h"

namespace glissade::check {

using Corners = std::array<Vector3, 3>;

/// The triangles of a surface, in a tree of balls and boxes. Immutable, shared by threads.
class PieceTree {
 public:
  explicit PieceTree(const std::vector<Corners>& triangles);

  struct Triangle {
    Corners corners;
    Vector3 normal;  ///< unit; zero for a triangle without area
  };
  struct Node {
    Box3 box;
    Vector3 middle;
    double radius = 0.0;       ///< radius of a ball about `middle`
    std::uint32_t first = 0;   ///< triangle for a leaf, else first child
    std::uint32_t second = 0;  ///< second child
    bool isLeaf = false;       ///< the node has one triangle
  };

  bool empty() const { return nodes_.empty(); }
  /// The first node is the root.
  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }

 private:
  void build(std::uint32_t node, std::uint32_t first, std::uint32_t last);

  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> order_;  ///< used while the tree is built
  std::vector<Node> nodes_;
};

}  // namespace glissade::check
