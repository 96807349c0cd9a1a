#pragma once

#include "widgets/scene3d/gizmo.h"
#include "widgets/scene3d/scene_pick.h"

namespace glissade {

/// How far a handle was dragged, or is moved by a key.
struct GizmoAmount {
  Vector3 shift = Vector3::Zero();  ///< metres along the gizmo's axes
  double angle = 0.0;               ///< radians about the handle's axis
};

/// Steps that amounts are rounded to.
struct GizmoSteps {
  double distance = 0.001;  ///< metres
  double angle = 0.0;       ///< radians; 0 (here and above): not rounded
};

GizmoAmount snapped(const GizmoAmount& amount, const GizmoSteps& steps);

/// The motion of the world that an amount is, for what is at the gizmo.
Pose motionOf(const GizmoAmount& amount, int axis, const Pose& X_WG);

/// A handle in the pointer's grip. The point that was gripped stays under the pointer as far as the handle allows.
/// Plain geometry.
class GizmoDrag {
 public:
  GizmoDrag(const GizmoHandle& handle, const Gizmo& gizmo, const Ray& grip);

  const GizmoHandle& handle() const { return handle_; }
  /// The gizmo as it was gripped.
  const Gizmo& gizmo() const { return gizmo_; }
  /// Since it was gripped; angles go on beyond a turn.
  const GizmoAmount& amount() const { return amount_; }
  /// Unit, in the plane of a ring: from its centre to where it was gripped.
  const Vector3& grippedAt() const { return grippedAt_; }

  /// Follows the pointer. Where the ray says nothing about the handle (parallel to it, or behind the eye), the amount
  /// stays.
  void moveTo(const Ray& ray);

 private:
  /// What the ray means, in the world: a point of the axis or of the plane.
  std::optional<Vector3> pointOf(const Ray& ray) const;
  void turnTo(const Vector3& p_W);

  GizmoHandle handle_;
  Gizmo gizmo_;
  Vector3 axis_;
  std::optional<Vector3> edge_;  ///< direction of the line that a ring is which is seen from its edge
  std::optional<Vector3> grip_;
  Vector3 grippedAt_ = Vector3::Zero();
  double lastAngle_ = 0.0;
  GizmoAmount amount_;
};

}  // namespace glissade
