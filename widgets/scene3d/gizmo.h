#pragma once

#include <array>
#include <optional>
#include <vector>

#include "widgets/scene3d/camera_controller.h"

namespace glissade {

/// A part of the gizmo that the pointer can take: an arrow moves along its axis, a small square across its axis, a
/// ring turns about its axis.
struct GizmoHandle {
  enum class Kind { Arrow, Square, Ring };
  Kind kind = Kind::Arrow;
  int axis = 0;  ///< 0, 1, 2: x, y, z of the gizmo's frame

  friend bool operator==(const GizmoHandle&, const GizmoHandle&) = default;
};

/// All handles. If two are equally near to the pointer, the earlier one is taken.
inline constexpr std::array<GizmoHandle, 9> kGizmoHandles{{{GizmoHandle::Kind::Arrow, 0},
                                                           {GizmoHandle::Kind::Arrow, 1},
                                                           {GizmoHandle::Kind::Arrow, 2},
                                                           {GizmoHandle::Kind::Square, 0},
                                                           {GizmoHandle::Kind::Square, 1},
                                                           {GizmoHandle::Kind::Square, 2},
                                                           {GizmoHandle::Kind::Ring, 0},
                                                           {GizmoHandle::Kind::Ring, 1},
                                                           {GizmoHandle::Kind::Ring, 2}}};

/// Handles at a frame of the world, sized for the view: `arm` metres long.
struct Gizmo {
  Pose X_WG;
  double arm = 1.0;
};

/// The gizmo at a frame whose arrows measure `arm` on the screen, in fractions of the view's height.
Gizmo gizmoAt(const Pose& X_WG, const CameraController& camera, double arm);

/// The direction of a gizmo's axis in the world, unit.
Vector3 axisOf(const Gizmo& gizmo, int axis);
/// The outline in the world: start and tip of an arrow; the corners of a square; a closed ring, whose last point is its
/// first one.
std::vector<Vector3> outlineOf(const GizmoHandle& handle, const Gizmo& gizmo);
/// The place of the axis' letter, behind the tip of its arrow.
Vector3 letterOf(const Gizmo& gizmo, int axis);

double ringRadius(const Gizmo& gizmo);
/// Whether the point of a ring is on the side of the eye.
bool isBeforeCentre(const Vector3& p_W, const Gizmo& gizmo, const CameraController& camera);
/// False for a handle that points at the eye or is seen from its edge: a small drag would move it far.
bool isUsable(const GizmoHandle& handle, const Gizmo& gizmo, const CameraController& camera);

/// The nearest handle on the screen within `margin` of the pointer. Both are in fractions of the view's height, the
/// pointer from the centre, y down. Of rings only the front half counts.
std::optional<GizmoHandle> handleAt(const Gizmo& gizmo, const CameraController& camera, const Eigen::Vector2d& pointer,
                                    double margin);

}  // namespace glissade
