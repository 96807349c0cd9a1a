#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/environment/rigid_body.h"
#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/solid_interior.h"

namespace glissade {

/// Settles what surfaces alone cannot: whether one solid lies wholly inside another. Boxes exclude
/// nearly every pair; only what fits inside is tested exactly. Immutable, shared by threads.
class Solids {
 public:
  /// What is known of a mesh, in the frame of its vertices. Occurrences of the mesh share it.
  struct Solid;
  using SolidPtr = std::shared_ptr<const Solid>;
  static SolidPtr prepare(const TriangleMesh& mesh);

  /// A solid in its place.
  struct Placed {
    SolidPtr solid;
    Pose X_WS;   ///< of the frame that it was prepared in
    Box3 box_W;  ///< around it
  };
  /// Obstacles, and the object in B.
  Solids(std::vector<Placed> obstacles, SolidPtr object);
  /// Another object among the same obstacles.
  Solids(const Solids& other, const TriangleMesh& object);

  /// Each obstacle, in its place, and the object.
  const std::vector<Placed>& obstacles() const { return *obstacles_; }
  const SolidPtr& object() const { return object_; }

  /// The lowest obstacle that contains the object, or that the object contains; nothing where none
  /// does. Precondition: the surfaces do not touch.
  std::optional<int> containment(const Pose& X_WB) const;

 private:
  using PlacedPtr = std::shared_ptr<const std::vector<Placed>>;
  /// A surface of the object that may lie in some solids.
  struct Guest {
    Vector3 point;
    std::vector<std::size_t> hosts;  ///< obstacles, the lowest first
  };
  /// A surface of an obstacle that may lie in the object.
  struct Core {
    Vector3 point;
    std::size_t obstacle;
  };

  Solids(PlacedPtr obstacles, SolidPtr object);
  /// The lowest obstacle, if it is below `limit`; else that.
  std::size_t aroundObject(const Pose& X_WB, std::size_t limit) const;
  std::size_t insideObject(const Pose& X_WB, std::size_t limit) const;

  PlacedPtr obstacles_;
  SolidPtr object_;
  double squaredReach_ = 0.0;  ///< of the object's box from its reference point
  std::vector<Guest> guests_;  ///< surfaces of the object
  std::vector<Core> cores_;    ///< the lowest obstacle first
};

struct Solids::Solid {
  Box3 box;                               ///< in the frame of the mesh
  std::optional<SolidInterior> interior;  ///< of a closed mesh
  /// If one touches nothing, its point decides for all of it.
  std::vector<ConnectedSurface> surfaces;
};

}  // namespace glissade
