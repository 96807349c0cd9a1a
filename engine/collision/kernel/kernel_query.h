#pragma once

#include <array>
#include <memory>

#include "engine/collision/kernel/motion_search.h"
#include "engine/collision/kernel/pair_traversal.h"
#include "engine/collision/surface_query.h"

namespace glissade {

/// The geometry of a world as the kernel wants it. Immutable, shared by threads. All lengths are multiplied
/// by `scale`, a power of two that brings the obstacles to a size near one: single precision neither overflows
/// nor underflows, and geometry in micrometres gives the same answers as geometry in kilometres.
struct KernelGeometry {
  KernelGeometry(const std::vector<RigidBody>& obstacles, const TriangleMesh& object);
  /// Another object among the same obstacles.
  KernelGeometry(const KernelGeometry& other, const TriangleMesh& object);
  /// Of trees that were made for this scale.
  KernelGeometry(double commonScale, std::shared_ptr<const BoxTree> obstacleTree,
                 std::shared_ptr<const BoxTree> objectTree);

  double scale;
  std::shared_ptr<const BoxTree> obstacles;  ///< world frame
  std::shared_ptr<const BoxTree> object;     ///< frame B
};

/// One over the size of the obstacles, as a power of two.
double kernelScale(const Box3& obstacles);
/// The tree of an obstacle in the frame of its mesh. The body has the number 0.
std::shared_ptr<const BoxTree> kernelObstacle(const TriangleMesh& mesh, double scale);
std::shared_ptr<const BoxTree> kernelObject(const TriangleMesh& mesh, double scale);

/// Our own kernel: wide hierarchies searched on vector units in single precision, which only ever rule
/// pairs out; what remains is decided in double precision, yes/no by exact predicates. So every answer
/// is a function of the pose alone: not of the instruction set, nor of what was asked before.
class KernelQuery final : public SurfaceQuery {
 public:
  explicit KernelQuery(std::shared_ptr<const KernelGeometry> geometry,
                       const lanes::LaneFunctions& functions = lanes::best());

  /// Asks another tree in place of the obstacles'; of the same scale. It has to outlive the query.
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
  /// The nearest pair of triangles so far; of equal ones the lowest.
  struct Best {
    double squared;
    TrianglePair pair;
  };

  Pose scaled(const Pose& X_WB) const { return {geometry_->scale * X_WB.position, X_WB.orientation}; }
  /// False where there is nothing, or spheres around all are farther apart than `bound` (scaled).
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
  std::vector<Candidate> candidates_;  ///< a heap, the nearest first: no more is opened than has to be
  std::vector<TriangleCandidate> triangles_;
  std::array<TrianglePair, 4>
      recent_;  ///< pairs that were near of late, the last first; as many as are looked at at once
  std::size_t recentCount_ = 0;
};

}  // namespace glissade
