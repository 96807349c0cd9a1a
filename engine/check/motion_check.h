#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/message.h"
#include "engine/base/work_watch.h"
#include "engine/check/evidence_names.h"
#include "engine/check/verdict.h"
#include "engine/evidence/body.h"
#include "engine/evidence/thread.h"

namespace glissade::check {

class Course;
class ThreadMotion;
struct Helix;

/// The judge of motions. It certifies a path independently of the planners, with which it shares only the meshes:
/// rotation vectors as course, a speed bound over every vertex, halving of time intervals, FCL's distances of surfaces,
/// and containment by counting ray crossings. Slow and simple.
class MotionCheck {
 public:
  /// An obstacle, prepared for any number of checks in one scale. Immutable.
  struct Obstacle;
  using ObstaclePtr = std::shared_ptr<const Obstacle>;
  static ObstaclePtr prepare(const TriangleMesh& mesh, const Pose& X_WB, double scale);
  /// The scale in which all of these meshes can be checked.
  static double scaleFor(const std::vector<const TriangleMesh*>& meshes, const std::vector<Body>& placed);

  /// An obstacle, and the shape of the object against it, in the frame of the path.
  struct Against {
    ObstaclePtr obstacle;
    MeshPtr object;
  };
  /// A thread that the object shares with an obstacle.
  struct Threaded {
    Thread thread;      ///< `other` is the number of the obstacle
    MeshPtr mesh;       ///< mesh of the obstacle without changes
    Pose X_WB;          ///< pose of the obstacle
    ObstaclePtr whole;  ///< `mesh`, prepared
  };
  /// `object`: the whole object, which contains all of its thinned shapes. Obstacles are numbered by their order.
  /// `threads`: an edge on which a thread is engaged has to be a screw motion about its axis by its pitch. On other
  /// edges the object and these obstacles are taken whole.
  MotionCheck(const std::vector<Against>& obstacles, const TriangleMesh& object, double scale,
              const std::vector<Threaded>& threads = {});
  ~MotionCheck();

  /// Judges each edge against its demand, up to the first one that fails. Clearances are bounded closely, except for
  /// screw motions that are judged as one: their edges get the clearance and the smallest distance of the whole motion.
  /// An edge that turns by half a circle is undecided, because rounding decides its sense.
  MotionVerdict check(const std::vector<Pose>& path, const std::vector<Demand>& demands,
                      const WorkWatch& watch = {}) const;

  /// The reason why check() leaves this motion undecided without a stop, as in "the edge turns by half a circle".
  Message whyUndecided(const Pose& from, const Pose& to, double requiredClearance) const;

 private:
  struct Group;
  struct Geometry;
  struct TurnProof;
  using Proofs = std::vector<std::optional<TurnProof>>;  ///< one entry for each edge
  /// Edges of a turn; runs of `least` or fewer edges are not divided.
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
  std::unique_ptr<const Geometry> whole_;  ///< for obstacles with threads; null: there are none
  std::unique_ptr<const ThreadMotion> threads_;
};

}  // namespace glissade::check
