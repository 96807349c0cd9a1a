#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/collision/motion_certificate.h"
#include "engine/collision/thread_rule.h"
#include "engine/environment/rigid_body.h"

namespace glissade {

class JudgedThreads;

/// The judge of paths: certifies a path with nothing of what planners use but the meshes. It has a
/// course of its own (rotation vectors), its own speed bound (every vertex), its own argument (halving
/// intervals of time), FCL's distances of surfaces, and its own test of containment (counting what a
/// ray crosses). Slow and simple.
class IndependentCheck {
 public:
  /// The object's frame is that of the path's configurations. `allowances`: by how much thinner the object is taken
  /// against each obstacle, metres, 0 for as it is; empty: against none. The check thins the object by itself.
  /// `threads`: an edge on which one is engaged has to be a screw motion about its axis by its pitch; on the others the
  /// object is whole against their obstacles.
  IndependentCheck(const std::vector<RigidBody>& obstacles, const TriangleMesh& object,
                   const std::vector<double>& allowances = {}, const std::vector<ThreadRule>& threads = {});
  ~IndependentCheck();

  /// Every edge against its demand, up to the first that does not keep it. Clearances are bounded
  /// closely. An edge that turns by half a circle is undecided: its sense is a matter of rounding.
  MotionCertificate check(const std::vector<Pose>& path, const std::vector<EdgeDemand>& demands,
                          const StopToken& stop = {}) const;

  /// Why check() leaves this motion undecided where nobody has stopped it, as "the edge turns by half a circle".
  std::string whyUndecided(const Pose& from, const Pose& to, double requiredClearance) const;

 private:
  struct Group;
  struct Geometry;
  static std::unique_ptr<const Geometry> geometryOf(const std::vector<RigidBody>& obstacles, const TriangleMesh& object,
                                                    const std::vector<double>& allowances);
  static MotionCertificate checkEdge(const Geometry& geometry, const Pose& from, const Pose& to, double required,
                                     const ThreadRule* thread, const StopToken& stop);

  std::unique_ptr<const Geometry> geometry_;
  std::unique_ptr<const Geometry> whole_;  ///< against the obstacles of threads; null where there are none
  std::unique_ptr<const JudgedThreads> threads_;
};

}  // namespace glissade
