#pragma once

#include <memory>

#include "engine/collision/collision_query.h"

namespace glissade {

/// The geometry of a world as FCL wants it: all obstacles in one hierarchy in the world frame, so
/// that one call answers for all of them. Meshes only: FCL's primitives and its continuous
/// collision are not to be trusted (their errors are listed in engine/README.md).
class FclGeometry;

std::shared_ptr<const FclGeometry> makeFclGeometry(const std::vector<RigidBody>& obstacles, const TriangleMesh& object);

/// A query of the surfaces alone: containment is not seen.
class FclSurfaceQuery {
 public:
  explicit FclSurfaceQuery(std::shared_ptr<const FclGeometry> geometry);

  bool surfacesTouch(const Pose& X_WB) const;
  /// Every obstacle whose surface touches the object's, ascending.
  std::vector<int> touchingBodies(const Pose& X_WB) const;
  /// Distance 0 where surfaces touch.
  NearestObstacle nearest(const Pose& X_WB) const;

 private:
  std::shared_ptr<const FclGeometry> geometry_;
};

}  // namespace glissade
