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

/// All of them. Where two are equally near to the pointer, the earlier one is meant.
inline constexpr std::array<GizmoHandle, 9> kGizmoHandles{{{GizmoHandle::Kind::Arrow, 0},
                                                           {GizmoHandle::Kind::Arrow, 1},
                                                           {GizmoHandle::Kind::Arrow, 2},
                                                           {GizmoHandle::Kind::Square, 0},
                                                           {GizmoHandle::Kind::Square, 1},
                                                           {GizmoHandle::Kind::Square, 2},
                                                           {GizmoHandle::Kind::Ring, 0},
                                                           {GizmoHandle::Kind::Ring, 1},
                                                           {GizmoHandle::Kind::Ring, 2}}};

/// Handles at a frame of the world, as large as the view needs them: `arm` metres long.
struct Gizmo {
  Pose X_WG;
  double arm = 1.0;
};

/// The gizmo at a frame whose arrows measure `arm` on the screen, in fractions of the view's height.
Gizmo gizmoAt(const Pose& X_WG, const CameraController& camera, double arm);

/// The directions of the gizmo's axes in the world, unit.
Vector3 axisOf(const Gizmo& gizmo, int axis);
/// Where an arrow begins and where its tip is; the corners of a square; a ring, closed, its first point again at the
/// end. In the world.
std::vector<Vector3> outlineOf(const GizmoHandle& handle, const Gizmo& gizmo);
/// The tip of an arrow: behind it the letter of its axis has room.
Vector3 letterOf(const Gizmo& gizmo, int axis);

double ringRadius(const Gizmo& gizmo);
/// Whether the point of a ring is on the side of the eye.
bool isBeforeCentre(const Vector3& p_W, const Gizmo& gizmo, const CameraController& camera);
/// False for what points at the eye or is seen from its edge: a drag there would be a leap.
bool isUsable(const GizmoHandle& handle, const Gizmo& gizmo, const CameraController& camera);

/// The handle that a pointer means: the nearest one on the screen within `margin`. Both in fractions of the view's
/// height, the pointer from the centre, y down. Of rings the front half counts.
std::optional<GizmoHandle> handleAt(const Gizmo& gizmo, const CameraController& camera, const Eigen::Vector2d& pointer,
                                    double margin);

}  // namespace glissade
