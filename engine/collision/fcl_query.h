#pragma once

#include <memory>

#include "engine/collision/surface_query.h"

namespace glissade {

/// The geometry of a world for FCL: all obstacles in one hierarchy in the world frame, so that one call answers for all
/// of them. Meshes only: FCL's primitives and its continuous collision are not reliable (their errors are listed in
/// engine/README.md).
class FclGeometry;

std::shared_ptr<const FclGeometry> makeFclGeometry(const std::vector<RigidBody>& obstacles, const TriangleMesh& object);

class FclSurfaceQuery final : public SurfaceQuery {
 public:
  explicit FclSurfaceQuery(std::shared_ptr<const FclGeometry> geometry);

  bool touches(const Pose& X_WB) override;
  std::optional<int> touchingBody(const Pose& X_WB) override;
  NearestObstacle nearest(const Pose& X_WB, double enough) override;
  bool isWithin(const Pose& X_WB, double bound) override;
  /// Returns nothing, because FCL's continuous collision is wrong.
  std::optional<MotionCheck> checkMotion(const Pose& from, const Pose& to, double required, SeekViolation seek,
                                         const StopToken& stop) override;

 private:
  std::shared_ptr<const FclGeometry> geometry_;
};

}  // namespace glissade
