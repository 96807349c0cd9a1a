#include "engine/product/alignment.h"

namespace glissade {
namespace {

using Kind = MeasureFeature::Kind;

/// `by` about a point that stays where it is.
Pose turnAbout(const Vector3& point, const Quaternion& by) { return {point - by * point, by}; }

/// The least turn that takes one unit vector to another. The second step mends the loss of digits of the first where
/// the two are nearly opposite.
Quaternion leastTurn(const Vector3& from, const Vector3& to) {
  const Quaternion nearly = Quaternion::FromTwoVectors(from, to).normalized();
  return (Quaternion::FromTwoVectors(nearly * from, to) * nearly).normalized();
}

}  // namespace

bool canAlign(const MeasureFeature& moving, const MeasureFeature& fixed) {
  return moving.kind == fixed.kind && (moving.kind == Kind::Face || moving.kind == Kind::Cylinder);
}

Pose alignment(const MeasureFeature& moving, const MeasureFeature& fixed, bool flipped) {
  const bool isAxis = moving.kind == Kind::Cylinder;
  const Vector3& line = fixed.direction;
  const bool opposite = (!isAxis || moving.direction.dot(line) < 0.0) != flipped;
  const Vector3 direction = opposite ? Vector3(-line) : line;
  const Vector3& pivot = isAxis ? moving.axisPoint : moving.picked;
  const Pose turned = turnAbout(pivot, leastTurn(moving.direction, direction));
  const Vector3 apart = (isAxis ? fixed.axisPoint : fixed.picked) - pivot;
  const Vector3 along = apart.dot(line) * line;
  return Pose::translation(isAxis ? Vector3(apart - along) : along) * turned;
}

}  // namespace glissade
