#pragma once

#include <cstdint>
#include <vector>

#include "engine/collision/kernel/lanes.h"
#include "engine/collision/kernel/oriented_box.h"

namespace glissade {

/// A triangle of a tree, with its body.
struct OwnedTriangle {
  Triangle corners;
  int body = 0;
};

/// The nodes and leaves of a tree.
struct BoxTreeNodes {
  struct Leaf {
    std::uint32_t first = 0;  ///< index in `triangles`
    std::uint32_t count = 0;
    lanes::TriangleLanes lanes{};
  };

  std::vector<lanes::BoxLanes> nodes;
  std::vector<std::uint32_t> counts;  ///< number of boxes of each node
  std::vector<Leaf> leaves;
  /// One entry for each box: the node below it, or -1 - leaf; the radius about its centre; the lowest body in it.
  std::vector<std::int32_t> child;
  std::vector<float> radius;
  std::vector<std::int32_t> lowestBody;

  /// Adds a node without boxes.
  std::uint32_t addNode();
  /// Appends the nodes and leaves of a part of the same tree.
  void append(const BoxTreeNodes& part);
};

/// How closely the boxes of a tree are fitted: for many queries, or so that the tree is made quickly for a few. The
/// answers are the same.
enum class BoxCare { ForManyQueries, ForFewQueries };

/// A wide hierarchy of oriented boxes. A node holds up to eight boxes, each around a node or a leaf of up to four
/// triangles. A box has the number node * 8 + lane; box 0 contains everything. Bounds are single precision, relative to
/// `centre`, and conservative with respect to rounding; the triangles themselves are stored in double precision.
/// Immutable, shared by threads.
class BoxTree : public BoxTreeNodes {
 public:
  using Box = std::uint32_t;

  /// Builds the tree. Large trees are built by several threads, and the boxes of the largest are fitted less closely.
  /// The tree depends on the triangles only.
  BoxTree(std::vector<OwnedTriangle> triangles, std::size_t mostInALeaf, BoxCare care = BoxCare::ForManyQueries);

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
