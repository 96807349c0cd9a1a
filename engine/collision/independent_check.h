#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/collision/motion_certificate.h"
#include "engine/collision/thread_rule.h"
#include "engine/environment/rigid_body.h"

namespace glissade {

class JudgedThreads;
struct JudgedHelix;

/// The judge of paths: certifies a path with nothing of what planners use but the meshes. It has a
/// course of its own (rotation vectors), its own speed bound (every vertex), its own argument (halving
/// intervals of time), FCL's distances of surfaces, and its own test of containment (counting what a
/// ray crosses). Slow and simple.
class IndependentCheck {
 public:
  /// An obstacle, prepared for any number of checks in one scale. Immutable.
  struct Obstacle;
  using ObstaclePtr = std::shared_ptr<const Obstacle>;
  static ObstaclePtr prepare(const RigidBody& body, double scale);
  /// The scale in which all of these can be checked.
  static double scaleFor(const std::vector<RigidBody>& bodies);

  /// An obstacle, and what the object is taken to be against it, in the frame of the path.
  struct Against {
    ObstaclePtr obstacle;
    MeshPtr object;
    bool fits;  ///< one of the two is thinned for the other one: they may be micrometres apart
  };
  /// A thread that the object has in common with an obstacle.
  struct Thread {
    ThreadRule rule;    ///< its obstacle is the number of the obstacle
    RigidBody body;     ///< the obstacle as it is
    ObstaclePtr whole;  ///< the same, prepared
  };
  /// `object`: whole, holds all that it is taken to be. Obstacles are numbered as they are listed. `threads`: an edge
  /// on which one is engaged has to be a screw motion about its axis by its pitch; on the others the object and the
  /// obstacles of threads are whole to each other.
  IndependentCheck(const std::vector<Against>& obstacles, const TriangleMesh& object, double scale,
                   const std::vector<Thread>& threads = {});

  /// The object's frame is that of the path's configurations. `allowances`: by how much thinner the object is taken
  /// against each obstacle, metres, 0 for as it is; empty: against none. The check thins the object by itself.
  /// `threads`: as above.
  IndependentCheck(const std::vector<RigidBody>& obstacles, const TriangleMesh& object,
                   const std::vector<double>& allowances = {}, const std::vector<ThreadRule>& threads = {});
  ~IndependentCheck();

  /// Every edge against its demand, up to the first that does not keep it. Clearances are bounded
  /// closely, but of screw motions of more than a turn, which are judged as one: their edges have the clearance and the
  /// smallest distance of the whole motion. An edge that turns by half a circle is undecided: its sense is a matter of
  /// rounding.
  MotionCertificate check(const std::vector<Pose>& path, const std::vector<EdgeDemand>& demands,
                          const StopToken& stop = {}) const;

  /// Why check() leaves this motion undecided where nobody has stopped it, as "the edge turns by half a circle".
  std::string whyUndecided(const Pose& from, const Pose& to, double requiredClearance) const;

 private:
  struct Group;
  struct Geometry;
  static std::unique_ptr<const Geometry> geometryOf(const std::vector<Against>& obstacles, const TriangleMesh& object,
                                                    double scale);
  std::vector<std::optional<MotionCertificate>> judgeHelices(const std::vector<Pose>& path,
                                                             const std::vector<EdgeDemand>& demands,
                                                             const StopToken& stop) const;
  static MotionCertificate judgeHelix(const Geometry& geometry, const std::vector<Pose>& path, const JudgedHelix& helix,
                                      double required, const StopToken& stop);
  static MotionCertificate checkEdge(const Geometry& geometry, const Pose& from, const Pose& to, double required,
                                     const ThreadRule* thread, const StopToken& stop);

  void build(const std::vector<Against>& obstacles, const TriangleMesh& object, double scale,
             const std::vector<Thread>& threads);

  std::unique_ptr<const Geometry> geometry_;
  std::unique_ptr<const Geometry> whole_;  ///< against the obstacles of threads; null where there are none
  std::unique_ptr<const JudgedThreads> threads_;
};

}  // namespace glissade
