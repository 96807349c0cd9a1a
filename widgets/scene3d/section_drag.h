#pragma once

#include "engine/geometry/section_plane.h"
#include "widgets/scene3d/gizmo_drag.h"

namespace glissade {

/// The handle of a section: an arrow from the middle of its outline to the side that is cut away. If the arrow points
/// at the eye, it is a knob, which is dragged up and down.
struct SectionHandle {
  Vector3 middle = Vector3::Zero();
  Vector3 normal = Vector3::UnitX();  ///< unit, to the side that is cut away
};

/// The handle of a section in the box of the drawn scene. A section beside the box has its handle beside it.
SectionHandle handleOf(const SectionPlane& section, const Box3& box);

/// The tip of the arrow; `length` in fractions of the view's height.
Vector3 tipOf(const SectionHandle& handle, const CameraController& camera, double length);
/// Whether the arrow points at the eye, or away from it.
bool isKnob(const SectionHandle& handle, const CameraController& camera);

/// A drag of a handle. The gripped point stays under the pointer; a knob moves away from the eye as far as the pointer
/// moves up.
class SectionDrag {
 public:
  SectionDrag(const SectionPlane& section, const SectionHandle& handle, const CameraController& camera,
              const Ray& grip);

  void moveTo(const Ray& ray) { drag_.moveTo(ray); }
  /// The section's place, metres along its direction.
  double place() const { return from_ + sign_ * drag_.amount().shift.z(); }

 private:
  double from_;
  double sign_ = 1.0;
  GizmoDrag drag_;
};

}  // namespace glissade
