#include "widgets/scene3d/gizmo.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace glissade {
namespace {

using Kind = GizmoHandle::Kind;

/// Lengths as shares of the arm.
constexpr double kArrowFrom = 0.16;
constexpr double kSquareFrom = 0.30;
constexpr double kSquareTo = 0.50;
constexpr double kRingRadius = 0.78;
constexpr double kLetter = 1.14;
/// Distance to a square from its inside, as a share of the margin. Lines across the square that are nearer are taken
/// before it.
constexpr double kInsideSquare = 0.4;
constexpr int kRingSteps = 72;
/// Sine of the angle between an arrow and the line of sight below which the arrow cannot be taken.
constexpr double kLeastArrowSine = 0.17;
/// Sine of the angle between a square and the line of sight below which the square cannot be taken.
constexpr double kLeastSquareSine = 0.17;

/// Direction from the eye to the gizmo, unit.
Vector3 sightOf(const Gizmo& gizmo, const CameraController& camera) {
  if (camera.isOrthographic()) return camera.R_WV() * -Vector3::UnitZ();
  return (gizmo.X_WG.position - camera.eye()).normalized();
}

double distanceToSegment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0.0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

/// Whether the point is inside a convex polygon of either orientation.
bool isInside(const Eigen::Vector2d& p, const std::vector<Eigen::Vector2d>& corners) {
  int left = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d side = corners[(i + 1) % corners.size()] - corners[i];
    const Eigen::Vector2d to = p - corners[i];
    left += side.x() * to.y() - side.y() * to.x() > 0.0 ? 1 : 0;
  }
  return left == 0 || left == static_cast<int>(corners.size());
}

/// Distance on the screen, in fractions of the view's height; infinite if the handle cannot be taken. It is `inside`
/// within a square, so that lines across the square can be taken there.
double distanceTo(const GizmoHandle& handle, const Gizmo& gizmo, const CameraController& camera,
                  const Eigen::Vector2d& pointer, double inside) {
  double least = std::numeric_limits<double>::infinity();
  if (!isUsable(handle, gizmo, camera)) return least;
  std::vector<Eigen::Vector2d> corners;
  const std::vector<Vector3> outline = outlineOf(handle, gizmo);
  for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
    const bool back = handle.kind == Kind::Ring && !isBeforeCentre(outline[i], gizmo, camera);
    const auto a = camera.project(outline[i]);
    const auto b = camera.project(outline[i + 1]);
    if (back || !a || !b) continue;
    least = std::min(least, distanceToSegment(pointer, *a, *b));
    corners.push_back(*a);
  }
  return handle.kind == Kind::Square && isInside(pointer, corners) ? inside : least;
}

}  // namespace

Gizmo gizmoAt(const Pose& X_WG, const CameraController& camera, double arm) {
  return {X_WG, arm * camera.viewHeightAt(X_WG.position)};
}

Vector3 axisOf(const Gizmo& gizmo, int axis) { return gizmo.X_WG.orientation * Vector3(Vector3::Unit(axis)); }

std::vector<Vector3> outlineOf(const GizmoHandle& handle, const Gizmo& gizmo) {
  const auto at = [&](double along, double u, double v) {
    Vector3 p_G;
    p_G[handle.axis] = along;
    p_G[(handle.axis + 1) % 3] = u;
    p_G[(handle.axis + 2) % 3] = v;
    return gizmo.X_WG * Vector3(gizmo.arm * p_G);
  };
  if (handle.kind == Kind::Arrow) return {at(kArrowFrom, 0.0, 0.0), at(1.0, 0.0, 0.0)};
  if (handle.kind == Kind::Square) {
    return {at(0.0, kSquareFrom, kSquareFrom), at(0.0, kSquareTo, kSquareFrom), at(0.0, kSquareTo, kSquareTo),
            at(0.0, kSquareFrom, kSquareTo), at(0.0, kSquareFrom, kSquareFrom)};
  }
  std::vector<Vector3> ring;
  for (int i = 0; i <= kRingSteps; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kRingSteps;
    ring.push_back(at(0.0, kRingRadius * std::cos(angle), kRingRadius * std::sin(angle)));
  }
  return ring;
}

Vector3 letterOf(const Gizmo& gizmo, int axis) {
  return gizmo.X_WG.position + kLetter * gizmo.arm * axisOf(gizmo, axis);
}

double ringRadius(const Gizmo& gizmo) { return kRingRadius * gizmo.arm; }

bool isBeforeCentre(const Vector3& p_W, const Gizmo& gizmo, const CameraController& camera) {
  // All points of a ring that is seen from straight above are before its centre.
  constexpr double kSlack = 0.02;
  return (p_W - gizmo.X_WG.position).dot(sightOf(gizmo, camera)) <= kSlack * gizmo.arm;
}

bool isUsable(const GizmoHandle& handle, const Gizmo& gizmo, const CameraController& camera) {
  const double cosine = std::abs(axisOf(gizmo, handle.axis).dot(sightOf(gizmo, camera)));
  if (handle.kind == Kind::Arrow) return std::sqrt(std::max(0.0, 1.0 - cosine * cosine)) >= kLeastArrowSine;
  return handle.kind == Kind::Ring || cosine >= kLeastSquareSine;
}

std::optional<GizmoHandle> handleAt(const Gizmo& gizmo, const CameraController& camera, const Eigen::Vector2d& pointer,
                                    double margin) {
  std::optional<GizmoHandle> nearest;
  double least = margin;
  for (const GizmoHandle& handle : kGizmoHandles) {
    const double distance = distanceTo(handle, gizmo, camera, pointer, kInsideSquare * margin);
    if (distance >= least) continue;
    least = distance;
    nearest = handle;
  }
  return nearest;
}

}  // namespace glissade
