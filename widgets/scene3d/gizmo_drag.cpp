#include "widgets/scene3d/gizmo_drag.h"

#include <cmath>
#include <numbers>

namespace glissade {
namespace {

using Kind = GizmoHandle::Kind;

/// Sine of the angle between the ray and a ring's plane below which the ring is a line.
constexpr double kEdgeSine = 0.2;
/// Squared sine of the angle between the ray and a line below which they are parallel.
constexpr double kParallelSquared = 1e-6;

/// The point of a line that is nearest to the ray; nothing if they are parallel, or it lies behind the eye.
std::optional<Vector3> nearestOnLine(const Vector3& origin, const Vector3& direction, const Ray& ray) {
  const double c = direction.dot(ray.direction);
  const double denominator = 1.0 - c * c;
  if (denominator < kParallelSquared) return std::nullopt;
  const Vector3 between = origin - ray.origin;
  const double alongRay = (ray.direction.dot(between) - c * direction.dot(between)) / denominator;
  if (alongRay <= 0.0) return std::nullopt;
  return origin + direction.dot(ray.origin + alongRay * ray.direction - origin) * direction;
}

std::optional<Vector3> onPlane(const Vector3& origin, const Vector3& normal, const Ray& ray) {
  const double along = ray.direction.dot(normal);
  if (std::abs(along) < 1e-6) return std::nullopt;
  const double distance = (origin - ray.origin).dot(normal) / along;
  if (distance <= 0.0) return std::nullopt;
  return ray.origin + distance * ray.direction;
}

double rounded(double value, double step) { return step > 0.0 ? step * std::round(value / step) : value; }

}  // namespace

GizmoAmount snapped(const GizmoAmount& amount, const GizmoSteps& steps) {
  GizmoAmount result{amount.shift, rounded(amount.angle, steps.angle)};
  for (double& metres : result.shift) metres = rounded(metres, steps.distance);
  return result;
}

Pose motionOf(const GizmoAmount& amount, int axis, const Pose& X_WG) {
  const Vector3 about = X_WG.orientation * Vector3(Vector3::Unit(axis));
  const Quaternion turn(Eigen::AngleAxisd(amount.angle, about));
  const Vector3& centre = X_WG.position;
  return {centre - turn * centre + X_WG.orientation * amount.shift, turn};
}

GizmoDrag::GizmoDrag(const GizmoHandle& handle, const Gizmo& gizmo, const Ray& grip)
    : handle_(handle), gizmo_(gizmo), axis_(axisOf(gizmo, handle.axis)) {
  if (handle.kind == Kind::Ring && std::abs(axis_.dot(grip.direction)) < kEdgeSine) {
    grippedAt_ = (-grip.direction + grip.direction.dot(axis_) * axis_).normalized();
    edge_ = axis_.cross(grippedAt_);
  }
  grip_ = pointOf(grip);
  if (grip_ && handle.kind == Kind::Ring && !edge_) {
    grippedAt_ = (*grip_ - gizmo.X_WG.position).stableNormalized();
  }
}

std::optional<Vector3> GizmoDrag::pointOf(const Ray& ray) const {
  const Vector3& centre = gizmo_.X_WG.position;
  if (handle_.kind == Kind::Arrow) return nearestOnLine(centre, axis_, ray);
  if (edge_) return nearestOnLine(centre + ringRadius(gizmo_) * grippedAt_, *edge_, ray);
  return onPlane(centre, axis_, ray);
}

void GizmoDrag::moveTo(const Ray& ray) {
  const auto point = pointOf(ray);
  if (!point) return;
  if (!grip_) grip_ = point;
  if (edge_) {
    amount_.angle = (*point - *grip_).dot(*edge_) / ringRadius(gizmo_);
  } else if (handle_.kind == Kind::Ring) {
    turnTo(*point);
  } else {
    amount_.shift = gizmo_.X_WG.orientation.conjugate() * Vector3(*point - *grip_);
    // The shift is exactly along the axis of an arrow, or exactly across that of a square.
    for (int axis = 0; axis < 3; ++axis) {
      if ((axis == handle_.axis) != (handle_.kind == Kind::Arrow)) amount_.shift[axis] = 0.0;
    }
  }
}

/// Adds the angle since the last call, by the short way round.
void GizmoDrag::turnTo(const Vector3& p_W) {
  const Vector3 to = p_W - gizmo_.X_WG.position;
  const double angle = std::atan2(axis_.cross(grippedAt_).dot(to), grippedAt_.dot(to));
  amount_.angle += std::remainder(angle - lastAngle_, 2.0 * std::numbers::pi);
  lastAngle_ = angle;
}

}  // namespace glissade
