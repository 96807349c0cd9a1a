#include "engine/geometry/pose_json.h"

#include <cmath>

#include "engine/base/tolerances.h"

namespace glissade {

using Json = JsonCursor::Json;

Vector3 readVector(const JsonCursor& at) {
  if (at.size() != 3) at.fail(GLISSADE_TEXT("is not a list of three numbers"));
  return {at.element(0).coordinate(), at.element(1).coordinate(), at.element(2).coordinate()};
}

Json VectorFormat::schema(SchemaDefinitions& /*definitions*/) const {
  return {{"type", "array"}, {"minItems", 3}, {"maxItems", 3}, {"items", {{"type", "number"}}}};
}

Quaternion QuaternionFormat::read(const JsonCursor& at) const {
  if (at.size() != 4) at.fail(GLISSADE_TEXT("is not a quaternion x, y, z, w"));
  Quaternion q;
  for (std::size_t i = 0; i < 4; ++i) q.coeffs()[static_cast<Eigen::Index>(i)] = at.element(i).number();
  const double norm = q.norm();
  if (std::abs(norm - 1.0) > tolerance::kQuaternionNorm) {
    at.fail({GLISSADE_TEXT("is not a unit quaternion (its length is %1)"), {std::to_string(norm)}},
            GLISSADE_TEXT("Divide its four numbers by that length."));
  }
  return q;
}

Json QuaternionFormat::write(const Quaternion& q) const { return Json::array({q.x(), q.y(), q.z(), q.w()}); }

Json QuaternionFormat::schema(SchemaDefinitions& /*definitions*/) const {
  const Json component{{"type", "number"}, {"minimum", -1.001}, {"maximum", 1.001}};
  return {{"type", "array"}, {"minItems", 4}, {"maxItems", 4}, {"items", component}};
}

Pose readPose(const JsonCursor& at) { return readDescribed<Pose>(at); }

Json toJson(const Vector3& v) { return Json::array({v.x(), v.y(), v.z()}); }

Json toJson(const Pose& pose) { return writeDescribed(pose); }

Vector3 DirectionFormat::read(const JsonCursor& at) const {
  const Vector3 direction = readVector(at);
  const double length = direction.norm();
  if (!(length > 1e-9)) at.fail(GLISSADE_TEXT("has no length"), GLISSADE_TEXT("Give a direction, as [0, 0, 1]."));
  return std::abs(length - 1.0) < 1e-12 ? direction : Vector3(direction / length);
}

}  // namespace glissade
