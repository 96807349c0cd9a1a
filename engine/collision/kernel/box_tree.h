#pragma once

#include <cstdint>
#include <vector>

#include "engine/collision/kernel/lanes.h"
#include "engine/collision/kernel/oriented_box.h"

namespace glissade {

/// A triangle of a tree, with the body that it belongs to.
struct OwnedTriangle {
  Triangle corners;
  int body = 0;
};

/// The nodes and leaves of a tree.
struct BoxTreeNodes {
  struct Leaf {
    std::uint32_t first = 0;  ///< in `triangles`
    std::uint32_t count = 0;
    lanes::TriangleLanes lanes{};
  };

  std::vector<lanes::BoxLanes> nodes;
  std::vector<std::uint32_t> counts;  ///< boxes of each node
  std::vector<Leaf> leaves;
  /// For each box: node below it, or -1 - leaf; radius about its centre; lowest body in it.
  std::vector<std::int32_t> child;
  std::vector<float> radius;
  std::vector<std::int32_t> lowestBody;

  /// Adds a node without boxes.
  std::uint32_t addNode();
  /// Adds those of a part of the same tree.
  void append(const BoxTreeNodes& part);
};

/// A wide hierarchy of oriented boxes: a node holds up to eight, each around a node or a leaf of up to
/// four triangles. A box is named by node * 8 + lane; box 0 is around everything. Bounds are single
/// precision, about `centre`, and hold what they say after rounding; the triangles themselves stay in
/// double. Immutable, shared by threads.
class BoxTree : public BoxTreeNodes {
 public:
  using Box = std::uint32_t;

  /// Large trees are built by several threads, and the boxes of the largest are fitted with less care. The tree is a
  /// function of the triangles alone.
  BoxTree(std::vector<OwnedTriangle> triangles, std::size_t mostInALeaf);

  bool empty() const { return triangles.empty(); }
  bool isLeaf(Box box) const { return child[box] < 0; }
  std::uint32_t nodeOf(Box box) const { return static_cast<std::uint32_t>(child[box]); }
  const Leaf& leafOf(Box box) const { return leaves[static_cast<std::size_t>(-1 - child[box])]; }
  static std::uint32_t nodeAround(Box box) { return box / lanes::kWidth; }
  static std::size_t laneOf(Box box) { return box % lanes::kWidth; }

  std::vector<OwnedTriangle> triangles;  ///< in the order of the leaves
  Vector3 centre = Vector3::Zero();
  double reach = 0.0;  ///< largest distance of a corner from the centre
};

}  // namespace glissade
