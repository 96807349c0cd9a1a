#include "engine/fits/alignment.h"

#include "engine/geometry/least_rotation.h"

#include <numbers>

namespace glissade {
namespace {

using FeatureKind = MeasureFeature::Kind;

enum class Form { Point, Line, Plane };

Form formOf(const MeasureFeature& feature) {
  switch (feature.kind) {
    case FeatureKind::Face: return Form::Plane;
    case FeatureKind::Edge:
    case FeatureKind::Cylinder:
    case FeatureKind::Cone:
    case FeatureKind::Torus: return Form::Line;
    default: return Form::Point;
  }
}

/// The point of the body that stays fixed while it turns.
const Vector3& pivotOf(const MeasureFeature& feature) {
  return feature.isTurned() || feature.kind == FeatureKind::Sphere ? feature.axisPoint : feature.picked;
}

/// The rotation `by` about a fixed point.
Pose turnAbout(const Vector3& point, const Quaternion& by) { return {point - by * point, by}; }

/// The smallest rotation that takes one unit vector to another. The second step restores the digits that the first one
/// loses for nearly opposite vectors.
Quaternion leastTurn(const Vector3& from, const Vector3& to) {
  const Quaternion nearly = leastRotation(from, to).normalized();
  return (leastRotation(nearly * from, to) * nearly).normalized();
}

/// The direction perpendicular to `line` that is nearest to `direction`. The second step restores the digits that are
/// lost for nearly parallel directions.
Vector3 nearestAcross(const Vector3& direction, const Vector3& line) {
  constexpr double kParallel = 1e-12;
  Vector3 across = direction - direction.dot(line) * line;
  if (across.norm() < kParallel) across = line.unitOrthogonal();
  across.normalize();
  return (across - across.dot(line) * line).normalized();
}

/// The direction of the fixed line or plane that the moving one takes.
Vector3 nearestAlong(const MeasureFeature& moving, const MeasureFeature& fixed, bool flipped) {
  const bool isLine = formOf(moving) == Form::Line;
  const bool opposite = (!isLine || moving.direction.dot(fixed.direction) < 0.0) != flipped;
  return opposite ? Vector3(-fixed.direction) : fixed.direction;
}

bool isTangency(const MeasureFeature& moving, const MeasureFeature& fixed) {
  const auto rolls = [](const MeasureFeature& feature) {
    return feature.kind == FeatureKind::Cylinder || feature.kind == FeatureKind::Sphere;
  };
  return rolls(moving) != rolls(fixed) && (formOf(moving) == Form::Plane) != (formOf(fixed) == Form::Plane);
}

/// The rotation of the body.
Quaternion turnOf(const MeasureFeature& moving, const MeasureFeature& fixed, bool flipped) {
  if (formOf(moving) == Form::Point || formOf(fixed) == Form::Point) return Quaternion::Identity();
  if (formOf(moving) == formOf(fixed)) return leastTurn(moving.direction, nearestAlong(moving, fixed, flipped));
  const Vector3 direction = nearestAcross(moving.direction, fixed.direction);
  const Quaternion turn = leastTurn(moving.direction, direction);
  if (!flipped || isTangency(moving, fixed)) return turn;
  const Vector3& edge = formOf(moving) == Form::Line ? direction : fixed.direction;
  return Quaternion(Eigen::AngleAxisd(std::numbers::pi, edge)) * turn;
}

/// Height of a cylinder's axis or of a sphere's centre over the plane.
double tangentHeight(const MeasureFeature& round, bool flipped) {
  return round.isHole != flipped ? -round.radius : round.radius;
}

/// The translation of the body after its rotation. `apart`: from the moving pivot to the fixed one.
Vector3 shiftOf(const MeasureFeature& turned, const MeasureFeature& fixed, const Vector3& apart, bool flipped) {
  const Form movingForm = formOf(turned);
  const Form fixedForm = formOf(fixed);
  if (movingForm == Form::Plane || fixedForm == Form::Plane) {
    const bool isFixed = fixedForm == Form::Plane;
    const Vector3& normal = isFixed ? fixed.direction : turned.direction;
    double along = apart.dot(normal);
    if (isTangency(turned, fixed)) along += isFixed ? tangentHeight(turned, flipped) : -tangentHeight(fixed, flipped);
    return along * normal;
  }
  if (movingForm == Form::Line || fixedForm == Form::Line) {
    const Vector3& line = fixedForm == Form::Line ? fixed.direction : turned.direction;
    return apart - apart.dot(line) * line;
  }
  return apart;
}

}  // namespace

bool canAlign(const MeasureFeature& moving, const MeasureFeature& fixed) {
  return moving.kind != FeatureKind::FreeFace && fixed.kind != FeatureKind::FreeFace;
}

bool canFlip(const MeasureFeature& moving, const MeasureFeature& fixed) {
  return canAlign(moving, fixed) && formOf(moving) != Form::Point && formOf(fixed) != Form::Point;
}

Pose alignment(const MeasureFeature& moving, const MeasureFeature& fixed, bool flipped) {
  const Pose turned = turnAbout(pivotOf(moving), turnOf(moving, fixed, flipped));
  const Vector3 apart = pivotOf(fixed) - pivotOf(moving);
  return Pose::translation(shiftOf(placed(moving, turned), fixed, apart, flipped)) * turned;
}

}  // namespace glissade
