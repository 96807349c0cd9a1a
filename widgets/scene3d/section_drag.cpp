#include "widgets/scene3d/section_drag.h"

#include "engine/geometry/least_rotation.h"

#include <algorithm>

namespace glissade {
namespace {

constexpr GizmoHandle kSectionArrow{GizmoHandle::Kind::Arrow, 2};

Gizmo alongZ(const Vector3& middle, const Vector3& direction) {
  return {{middle, leastRotation(Vector3::UnitZ(), direction)}, 1.0};
}

Vector3 upOf(const CameraController& camera) { return camera.R_WV() * Vector3::UnitY(); }

}  // namespace

SectionHandle handleOf(const SectionPlane& section, const Box3& box) {
  const Plane plane = planeOf(section);
  const Vector3 centre = box.isEmpty() ? Vector3::Zero() : Vector3(box.center());
  SectionHandle handle{centre + (plane.offset - plane.normal.dot(centre)) * plane.normal, plane.normal};
  const std::vector<Vector3> outline = outlineInBox(plane, box);
  if (outline.empty()) return handle;
  handle.middle = Vector3::Zero();
  for (const Vector3& corner : outline) handle.middle += corner / static_cast<double>(outline.size());
  return handle;
}

Vector3 tipOf(const SectionHandle& handle, const CameraController& camera, double length) {
  return handle.middle + length * camera.viewHeightAt(handle.middle) * handle.normal;
}

bool isKnob(const SectionHandle& handle, const CameraController& camera) {
  return !isUsable(kSectionArrow, alongZ(handle.middle, handle.normal), camera);
}

SectionDrag::SectionDrag(const SectionPlane& section, const SectionHandle& handle, const CameraController& camera,
                         const Ray& grip)
    : from_(section.place),
      drag_(kSectionArrow, alongZ(handle.middle, isKnob(handle, camera) ? upOf(camera) : section.direction), grip) {
  const bool pointsAtEye = section.direction.dot(camera.eye() - handle.middle) > 0.0;
  if (isKnob(handle, camera) && pointsAtEye) sign_ = -1.0;
}

}  // namespace glissade
