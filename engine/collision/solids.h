#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/solid_interior.h"
#include "engine/places/rigid_body.h"

namespace glissade {

/// Decides whether one solid lies wholly inside another, which the surfaces alone do not show. Boxes exclude nearly
/// every pair; only bodies that fit inside are tested exactly. Immutable, shared by threads.
class Solids {
 public:
  /// Prepared data of a mesh, in the frame of its vertices. Occurrences of the mesh share it.
  struct Solid;
  using SolidPtr = std::shared_ptr<const Solid>;
  static SolidPtr prepare(const TriangleMesh& mesh);

  /// A placed solid.
  struct Placed {
    SolidPtr solid;
    Pose X_WS;   ///< pose of the frame in which it was prepared
    Box3 box_W;  ///< bounding box
  };
  /// Solids of these obstacles and of the object in frame B.
  Solids(std::vector<Placed> obstacles, SolidPtr object);
  /// Another object among the same obstacles.
  Solids(const Solids& other, const TriangleMesh& object);

  /// The placed obstacles, and the object.
  const std::vector<Placed>& obstacles() const { return *obstacles_; }
  const SolidPtr& object() const { return object_; }

  /// The lowest obstacle that contains the object, or that the object contains; nothing where none
  /// does. Precondition: the surfaces do not touch.
  std::optional<int> containment(const Pose& X_WB) const;

 private:
  using PlacedPtr = std::shared_ptr<const std::vector<Placed>>;
  /// A surface of the object that may lie inside some solids.
  struct Guest {
    Vector3 point;
    std::vector<std::size_t> hosts;  ///< indices of obstacles, ascending
  };
  /// A surface of an obstacle that may lie inside the object.
  struct Core {
    Vector3 point;
    std::size_t obstacle;
  };

  Solids(PlacedPtr obstacles, SolidPtr object);
  /// Lowest index of an obstacle around (inside) the object, if it is below `limit`; else `limit`.
  std::size_t aroundObject(const Pose& X_WB, std::size_t limit) const;
  std::size_t insideObject(const Pose& X_WB, std::size_t limit) const;

  PlacedPtr obstacles_;
  SolidPtr object_;
  double squaredReach_ = 0.0;  ///< square of the largest distance of the object's box from its reference point
  std::vector<Guest> guests_;  ///< surfaces of the object
  std::vector<Core> cores_;    ///< surfaces of obstacles, the lowest obstacle first
};

struct Solids::Solid {
  Box3 box;                               ///< bounding box in the frame of the mesh
  std::optional<SolidInterior> interior;  ///< interior of a closed mesh
  /// If a surface touches nothing, one of its points decides for the whole surface.
  std::vector<ConnectedSurface> surfaces;
};

}  // namespace glissade
