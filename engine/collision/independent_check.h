#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/collision/motion_certificate.h"
#include "engine/environment/rigid_body.h"

namespace glissade {

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
  /// `object`: whole, holds all that it is taken to be. Obstacles are numbered as they are listed.
  IndependentCheck(const std::vector<Against>& obstacles, const TriangleMesh& object, double scale);

  /// The object's frame is that of the path's configurations. `allowances`: by how much thinner the object is taken
  /// against each obstacle, metres, 0 for as it is; empty: against none. The check thins the object by itself.
  IndependentCheck(const std::vector<RigidBody>& obstacles, const TriangleMesh& object,
                   const std::vector<double>& allowances = {});
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
  MotionCertificate checkEdge(const Pose& from, const Pose& to, double required, const StopToken& stop) const;

  void build(const std::vector<Against>& obstacles, const TriangleMesh& object, double scale);

  std::unique_ptr<const Geometry> geometry_;
};

}  // namespace glissade
