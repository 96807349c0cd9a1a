#pragma once

#include "widgets/scene3d/gizmo.h"
#include "widgets/scene3d/scene_pick.h"

namespace glissade {

/// The amount by which a handle was dragged, or is moved by a key.
struct GizmoAmount {
  Vector3 shift = Vector3::Zero();  ///< metres along the gizmo's axes
  double angle = 0.0;               ///< radians about the handle's axis
};

/// Steps to which amounts are rounded.
struct GizmoSteps {
  double distance = 0.001;  ///< metres; 0: not rounded
  double angle = 0.0;       ///< radians; 0: not rounded
};

GizmoAmount snapped(const GizmoAmount& amount, const GizmoSteps& steps);

/// The motion in the world for an amount of a handle, applied to bodies at the gizmo.
Pose motionOf(const GizmoAmount& amount, int axis, const Pose& X_WG);

/// A drag of a handle by the pointer. The gripped point stays under the pointer as far as the handle allows. It is
/// plain geometry.
class GizmoDrag {
 public:
  GizmoDrag(const GizmoHandle& handle, const Gizmo& gizmo, const Ray& grip);

  const GizmoHandle& handle() const { return handle_; }
  /// The gizmo at the beginning of the drag.
  const Gizmo& gizmo() const { return gizmo_; }
  /// The amount since the beginning; angles continue beyond a turn.
  const GizmoAmount& amount() const { return amount_; }
  /// Unit vector in the plane of a ring, from its centre to the gripped point.
  const Vector3& grippedAt() const { return grippedAt_; }

  /// Follows the pointer. If the ray is parallel to the handle, or meets it behind the eye, the amount stays.
  void moveTo(const Ray& ray);

 private:
  /// The point of the axis or of the plane to which the ray points, in the world.
  std::optional<Vector3> pointOf(const Ray& ray) const;
  void turnTo(const Vector3& p_W);

  GizmoHandle handle_;
  Gizmo gizmo_;
  Vector3 axis_;
  std::optional<Vector3> edge_;  ///< direction of a ring that is seen from its edge as a line
  std::optional<Vector3> grip_;
  Vector3 grippedAt_ = Vector3::Zero();
  double lastAngle_ = 0.0;
  GizmoAmount amount_;
};

}  // namespace glissade
