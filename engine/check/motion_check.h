#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/work_watch.h"
#include "engine/check/body.h"
#include "engine/check/thread.h"
#include "engine/check/verdict.h"

namespace glissade::check {

class Course;
class ThreadMotion;
struct Helix;

/// The judge of motions: certifies a path with nothing of what planners use but the meshes. It has a course of its own
/// (rotation vectors), its own speed bound (every vertex), its own argument (halving intervals of time), FCL's
/// distances of surfaces, and its own test of containment (counting what a ray crosses). Slow and simple.
class MotionCheck {
 public:
  /// An obstacle, prepared for any number of checks in one scale. Immutable.
  struct Obstacle;
  using ObstaclePtr = std::shared_ptr<const Obstacle>;
  static ObstaclePtr prepare(const TriangleMesh& mesh, const Pose& X_WB, double scale);
  /// The scale in which all of these can be checked.
  static double scaleFor(const std::vector<const TriangleMesh*>& meshes, const std::vector<Body>& placed);

  /// An obstacle, and what the object is taken to be against it, in the frame of the path.
  struct Against {
    ObstaclePtr obstacle;
    MeshPtr object;
  };
  /// A thread that the object has in common with an obstacle.
  struct Threaded {
    Thread thread;      ///< `other` is the number of the obstacle
    MeshPtr mesh;       ///< the obstacle as it is
    Pose X_WB;          ///< of the obstacle
    ObstaclePtr whole;  ///< the same, prepared
  };
  /// `object`: whole, holds all that it is taken to be. Obstacles are numbered as they are listed. `threads`: an edge
  /// on which one is engaged has to be a screw motion about its axis by its pitch; on the others the object and the
  /// obstacles of threads are whole to each other.
  MotionCheck(const std::vector<Against>& obstacles, const TriangleMesh& object, double scale,
              const std::vector<Threaded>& threads = {});
  ~MotionCheck();

  /// Every edge against its demand, up to the first that does not keep it. Clearances are bounded closely, but of screw
  /// motions that are judged as one: their edges have the clearance and the smallest distance of the whole motion. An
  /// edge that turns by half a circle is undecided: its sense is a matter of rounding.
  MotionVerdict check(const std::vector<Pose>& path, const std::vector<Demand>& demands,
                      const WorkWatch& watch = {}) const;

  /// Why check() leaves this motion undecided where nobody has stopped it, as "the edge turns by half a circle".
  std::string whyUndecided(const Pose& from, const Pose& to, double requiredClearance) const;

 private:
  struct Group;
  struct Geometry;
  struct TurnProof;
  using Proofs = std::vector<std::optional<TurnProof>>;  ///< of each edge
  /// Edges of a turn; they are not divided below `least` edges.
  struct Run {
    std::size_t first;
    std::size_t last;
    std::size_t least;
  };
  static std::unique_ptr<const Geometry> geometryOf(const std::vector<Against>& obstacles, const TriangleMesh& object,
                                                    double scale, const std::vector<bool>& inThread);
  std::vector<std::optional<MotionVerdict>> judgeHelices(const std::vector<Pose>& path,
                                                         const std::vector<Demand>& demands,
                                                         const StopToken& stop) const;
  static MotionVerdict judgeHelix(const Geometry& geometry, const std::vector<Pose>& path, const Helix& helix,
                                  double required, const StopToken& stop);
  static MotionVerdict checkEdge(const Geometry& geometry, const Pose& from, const Pose& to, double required,
                                 const TurnProof* turn, std::optional<Nearest>& atEnd, const StopToken& stop);
  static void meetEnds(const Geometry& geometry, const Course& course, const std::vector<bool>& asked,
                       std::optional<Nearest>& atEnd, MotionVerdict& result);
  static bool proveStanding(const Geometry& geometry, const Course& course, MotionVerdict& result);
  static bool proveBySweep(const Geometry& geometry, const Course& course, const std::vector<bool>& asked,
                           MotionVerdict& result);
  static void proveByPieces(const Geometry& geometry, const Course& course, const std::vector<bool>& asked,
                            const StopToken& stop, MotionVerdict& result);
  void proveTurns(const std::vector<Pose>& path, const std::vector<Demand>& demands, const Thread& thread,
                  const Run& run, Proofs& proofs, const StopToken& stop) const;
  Proofs turnProofs(const std::vector<Pose>& path, const std::vector<Demand>& demands,
                    const std::vector<const Thread*>& turned, const StopToken& stop) const;

  std::unique_ptr<const Geometry> geometry_;
  std::unique_ptr<const Geometry> whole_;  ///< against the obstacles of threads; null where there are none
  std::unique_ptr<const ThreadMotion> threads_;
};

}  // namespace glissade::check
