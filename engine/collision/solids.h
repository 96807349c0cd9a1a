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

  /// The lowest obstacle that contains the object, or that the object contains; nothing where none
  /// does. Precondition: the surfaces do not touch.
  std::optional<int> containment(const Pose& X_WB) const;

 private:
  /// A connected surface: if it touches nothing, one point decides for all of it.
  struct Component {
    Vector3 point;
    Box3 box;
  };
  struct Solid {
    Box3 box;                               ///< in the world for obstacles, in B for the object
    std::optional<SolidInterior> interior;  ///< of a closed mesh
    std::vector<Component> components;
  };

  static Solid makeSolid(const TriangleMesh& mesh);
  static std::vector<Solid> makeSolids(const std::vector<RigidBody>& bodies);
  bool objectInside(const Solid& obstacle, const Pose& X_WB) const;
  bool objectAround(const Solid& obstacle, const Pose& X_BW) const;

  std::shared_ptr<const std::vector<Solid>> obstacles_;
  Solid object_;
};

}  // namespace glissade
