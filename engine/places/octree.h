#pragma once

#include <functional>
#include <map>
#include <optional>

#include "engine/places/coverage.h"
#include "engine/places/rigid_body.h"

namespace glissade {

/// The paper's three kinds of cell (paper 2, section 3.2).
enum class CellKind : std::uint8_t {
  Free,    ///< intersects no rigid body
  Mobile,  ///< intersects mobile bodies only
  Static   ///< intersects at least one static body
};

/// The bodies that clutter a cell (paper 2, section 5.1.2): indices of bodies, ascending.
struct Clutter {
  std::vector<int> staticBodies;
  std::vector<int> mobileBodies;

  CellKind kind() const {
    if (!staticBodies.empty()) return CellKind::Static;
    return mobileBodies.empty() ? CellKind::Free : CellKind::Mobile;
  }
  friend bool operator==(const Clutter&, const Clutter&) = default;
};

/// Resolution of an octree: by the size of its finest cells, or by its largest memory.
struct OctreeResolution {
  double cellSize = 0.0;           ///< largest edge of the finest cells, metres; 0: by memory
  std::size_t memory = 64U << 20;  ///< memory in bytes; used where cellSize is 0
};

/// The geometrical layer of the free space: an unbalanced octree over the workspace (Chen and Huang 1988, as paper 2
/// adapts it). It is the smallest octree of its finest cells: eight leaves with the same clutter are one. It does not
/// depend on the order of changes, so that moving a body gives the same tree as building anew.
class Octree {
 public:
  static constexpr int kDeepest = 10;

  /// Bodies outside the workspace are ignored. Closed bodies occupy their inside. Unfinished after a stop.
  Octree(const std::vector<RigidBody>& bodies, const Box3& workspace, const OctreeResolution& resolution,
         const StopToken& stop = {});

  /// Number of cells that a move has changed.
  struct Change {
    std::uint64_t cellsLeft = 0;     ///< finest cells that the body does not clutter any more
    std::uint64_t cellsEntered = 0;  ///< finest cells that it clutters now
  };
  /// Moves a body: only the cells that it leaves or enters are rebuilt, by merging and splitting (paper 2, section
  /// 5.1.2).
  Change moveBody(std::size_t body, const Pose& X_WB);
  /// This octree with its mobile bodies at the poses of `bodies`, with cells of the same size. Nothing where anything
  /// else differs: other bodies, another mobility, another pose of a static body.
  std::optional<Octree> withMobileBodiesAt(const std::vector<RigidBody>& bodies) const;

  struct Leaf {
    Cell cell;
    CellKind kind;
    const Clutter& clutter;
  };
  /// Calls `visit` for every leaf, in Z order.
  void forEachLeaf(const std::function<void(const Leaf&)>& visit) const;
  /// Clutter of the leaf that holds a finest cell.
  const Clutter& clutterAt(const std::array<std::uint32_t, 3>& finest) const;

  const CellFrame& frame() const { return frame_; }
  const Box3& workspace() const { return workspace_; }
  int depth() const { return depth_; }
  std::size_t leafCount() const;
  /// Leaves of each kind, indexed by CellKind.
  std::array<std::size_t, 3> leafCounts() const;

  /// True if both have the same cells with the same clutter.
  friend bool operator==(const Octree& a, const Octree& b);

 private:
  using ClutterId = std::uint32_t;
  struct Node {
    std::int32_t firstChild = -1;  ///< -1: a leaf
    ClutterId clutter = 0;
  };
  struct Occupant {
    MeshPtr mesh;
    Mobility mobility;
    bool closed;
    Pose X_WB;
    CellRuns cells;
  };
  enum class Edit { Add, Remove };

  void addAll(const StopToken& stop);
  CellRuns coverage(const Occupant& body, const StopToken& stop = {}) const;
  /// Coverage of a body that moves to a pose. A face that slides in its own plane is only evaluated at its rim.
  CellRuns coverageAt(const Occupant& body, const Pose& X_WB) const;
  void edit(std::size_t body, const CellRuns& cells, Edit edit);
  void editNode(std::size_t node, std::uint64_t begin, int level, CellRuns::const_iterator& run,
                CellRuns::const_iterator end);
  ClutterId edited(ClutterId clutter);
  ClutterId intern(const Clutter& clutter);
  void split(std::size_t node);
  void mergeIfUniform(std::size_t node);
  void visitLeaves(std::size_t node, const Cell& cell, const std::function<void(const Leaf&)>& visit) const;

  CellFrame frame_;
  Box3 workspace_;
  int depth_ = 0;
  std::vector<Occupant> bodies_;
  std::vector<Node> nodes_;
  std::vector<std::int32_t> spareChildren_;  ///< first nodes of groups of eight that were merged
  std::vector<Clutter> clutters_;
  std::map<std::pair<std::vector<int>, std::vector<int>>, ClutterId> clutterIds_;

  std::size_t editedBody_ = 0;
  Edit editing_ = Edit::Add;
  std::map<ClutterId, ClutterId> editedClutter_;  ///< cache of edited(), for one edit()
};

}  // namespace glissade
