#pragma once

#include <array>
#include <memory>

#include "engine/collision/kernel/motion_search.h"
#include "engine/collision/kernel/pair_traversal.h"
#include "engine/collision/surface_query.h"

namespace glissade {

/// The geometry of a world for the kernel. Immutable, shared by threads. All lengths are multiplied by `scale`, a power
/// of two that brings the obstacles to a size near one. So single precision neither overflows nor underflows, and
/// geometry in micrometres gives the same answers as geometry in kilometres.
struct KernelGeometry {
  KernelGeometry(const std::vector<RigidBody>& obstacles, const TriangleMesh& object);
  /// Makes the geometry of another object among the same obstacles.
  KernelGeometry(const KernelGeometry& other, const TriangleMesh& object);
  /// Makes the geometry from trees of this scale.
  KernelGeometry(double commonScale, std::shared_ptr<const BoxTree> obstacleTree,
                 std::shared_ptr<const BoxTree> objectTree);

  double scale;
  std::shared_ptr<const BoxTree> obstacles;  ///< tree in the world frame
  std::shared_ptr<const BoxTree> object;     ///< tree in frame B
};

/// Scale of the kernel: one over the size of the obstacles, as a power of two.
double kernelScale(const Box3& obstacles);
/// The tree of an obstacle in the frame of its mesh. The body has the number 0.
std::shared_ptr<const BoxTree> kernelObstacle(const TriangleMesh& mesh, double scale,
                                              BoxCare care = BoxCare::ForManyQueries);
std::shared_ptr<const BoxTree> kernelObject(const TriangleMesh& mesh, double scale,
                                            BoxCare care = BoxCare::ForManyQueries);

/// Our own kernel: wide hierarchies that are searched on vector units in single precision, which only excludes pairs.
/// The remaining pairs are decided in double precision, yes/no queries by exact predicates. So every answer depends on
/// the pose only, not on the instruction set nor on earlier queries.
class KernelQuery final : public SurfaceQuery {
 public:
  explicit KernelQuery(std::shared_ptr<const KernelGeometry> geometry,
                       const lanes::LaneFunctions& functions = lanes::best());

  /// Queries another tree instead of the obstacles', which has the same scale. The tree must outlive the query.
  void setObstacles(const BoxTree& obstacles);

  bool touches(const Pose& X_WB) override;
  std::optional<int> touchingBody(const Pose& X_WB) override;
  NearestObstacle nearest(const Pose& X_WB, double enough) override;
  bool isWithin(const Pose& X_WB, double bound) override;
  std::optional<MotionCheck> checkMotion(const Pose& from, const Pose& to, double required, SeekViolation seek,
                                         const StopToken& stop) override;
  std::uint64_t pairs() const override { return traversal_.pairs(); }

 private:
  struct Candidate {
    BoxPair pair;
    float squared;  ///< lower bound
  };
  static bool farther(const Candidate& a, const Candidate& b) { return a.squared > b.squared; }
  struct TriangleCandidate {
    TrianglePair pair;
    float squared;  ///< lower bound
  };
  /// The nearest pair of triangles so far; the lowest among equals.
  struct Best {
    double squared;
    TrianglePair pair;
  };

  Pose scaled(const Pose& X_WB) const { return {geometry_->scale * X_WB.position, X_WB.orientation}; }
  /// Moves the object. False where there are no triangles, or spheres around all are farther apart than `bound`
  /// (scaled).
  bool moveTo(const Pose& X_WB, double bound);
  bool leavesMeet(const BoxPair& leaves, int bodiesBelow, int& body);
  bool leavesWithin(const BoxPair& leaves, double bound);
  void pushWithin(const PairTraversal::Opened& opened, float reach);
  void push(const PairTraversal::Opened& opened, float bound);
  Candidate pop();
  float collect(float bound, bool byEstimates);
  void decide(Best& best);
  bool recentlyWithin(double bound);
  void remember(const TrianglePair& pair);

  std::shared_ptr<const KernelGeometry> geometry_;
  PairTraversal traversal_;
  std::vector<BoxPair> stack_;
  MotionSearch::Stacks motionStacks_;
  /// Heap with the nearest pair first, so that no more pairs are opened than necessary.
  std::vector<Candidate> candidates_;
  std::vector<TriangleCandidate> triangles_;
  std::array<TrianglePair, 4> recent_;  ///< recently near pairs, the last first; as many as are tested at once
  std::size_t recentCount_ = 0;
};

}  // namespace glissade
