#include "engine/geometry/pose_json.h"

#include <cmath>

#include "engine/base/tolerances.h"

namespace glissade {

using Json = JsonCursor::Json;

Vector3 readVector(const JsonCursor& at) {
  if (at.size() != 3) at.fail(GLISSADE_TEXT("is not a list of three numbers"));
  return {at.element(0).coordinate(), at.element(1).coordinate(), at.element(2).coordinate()};
}

Pose readPose(const JsonCursor& at) {
  at.allowOnly({"position", "orientation"});
  Pose pose;
  pose.position = readVector(at.at("position"));
  const JsonCursor orientation = at.at("orientation");
  if (orientation.size() != 4) orientation.fail(GLISSADE_TEXT("is not a quaternion x, y, z, w"));
  for (std::size_t i = 0; i < 4; ++i) {
    pose.orientation.coeffs()[static_cast<Eigen::Index>(i)] = orientation.element(i).number();
  }
  const double norm = pose.orientation.norm();
  if (std::abs(norm - 1.0) > tolerance::kQuaternionNorm) {
    orientation.fail({GLISSADE_TEXT("is not a unit quaternion (its length is %1)"), {std::to_string(norm)}},
                     GLISSADE_TEXT("Divide its four numbers by that length."));
  }
  return pose;
}

Json toJson(const Vector3& v) { return Json::array({v.x(), v.y(), v.z()}); }

Json toJson(const Pose& pose) {
  const Quaternion& q = pose.orientation;
  return {{"position", toJson(pose.position)}, {"orientation", Json::array({q.x(), q.y(), q.z(), q.w()})}};
}

}  // namespace glissade
