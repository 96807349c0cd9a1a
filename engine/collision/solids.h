#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/environment/rigid_body.h"
#include "engine/geometry/solid_interior.h"

namespace glissade {

/// Settles what surfaces alone cannot: whether one solid lies wholly inside another. Boxes exclude
/// nearly every pair; only what fits inside is tested exactly. Immutable, shared by threads.
class Solids {
 public:
  Solids(const std::vector<RigidBody>& obstacles, const TriangleMesh& object);
  /// Another object among the same obstacles.
  Solids(const Solids& other, const TriangleMesh& object);
  /// Other obstacles, of which those that were among `before` (the obstacles of `other`) with the same mesh and pose
  /// are not prepared again. `object` null: the same.
  Solids(const Solids& other, const std::vector<RigidBody>& before, const std::vector<RigidBody>& obstacles,
         const TriangleMesh* object);

  /// What is known of a mesh, in the frame that its vertices are in.
  struct Solid;
  using SolidPtr = std::shared_ptr<const Solid>;
  static SolidPtr prepare(const TriangleMesh& mesh);
  /// Of prepared ones: the obstacle is prepared in the world, the object in B.
  Solids(const SolidPtr& obstacle, SolidPtr object);

  /// The lowest obstacle that contains the object, or that the object contains; nothing where none
  /// does. Precondition: the surfaces do not touch.
  std::optional<int> containment(const Pose& X_WB) const;

 private:
  /// A connected surface: if it touches nothing, one point decides for all of it.
  struct Component {
    Vector3 point;
    Box3 box;
  };
  using SolidsPtr = std::shared_ptr<const std::vector<SolidPtr>>;
  /// A component that may lie in some solids.
  struct Guest {
    Vector3 point;
    std::vector<std::size_t> hosts;  ///< obstacles, the lowest first
  };
  /// A component of an obstacle that may lie in the object.
  struct Core {
    Vector3 point;
    std::size_t obstacle;
  };

  Solids(SolidsPtr obstacles, SolidPtr object);
  static SolidsPtr makeSolids(const std::vector<RigidBody>& bodies);
  static SolidsPtr makeSolids(const std::vector<RigidBody>& bodies, const std::vector<RigidBody>& before,
                              const std::vector<SolidPtr>& known);
  /// The lowest obstacle, if it is below `limit`; else that.
  std::size_t aroundObject(const Pose& X_WB, std::size_t limit) const;
  std::size_t insideObject(const Pose& X_WB, std::size_t limit) const;

  SolidsPtr obstacles_;
  SolidPtr object_;
  double squaredReach_ = 0.0;  ///< of the object's box from its reference point
  std::vector<Guest> guests_;  ///< components of the object
  std::vector<Core> cores_;    ///< the lowest obstacle first
};

struct Solids::Solid {
  Box3 box;                               ///< in the world for obstacles, in B for the object
  std::optional<SolidInterior> interior;  ///< of a closed mesh
  std::vector<Component> components;
};

}  // namespace glissade
