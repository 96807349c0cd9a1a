// Conversions to the values of OpenXR.
#pragma once

#include <openxr/openxr.h>

#include <cmath>

#include "widgets/openxr/eye_sight.h"

namespace glissade::test {

inline XrPosef toXr(const Pose& pose) {
  const Quaternion& q = pose.orientation;
  const Vector3& p = pose.position;
  return {{static_cast<float>(q.x()), static_cast<float>(q.y()), static_cast<float>(q.z()), static_cast<float>(q.w())},
          {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())}};
}

inline XrFovf toXr(const EyeSides& sides) {
  const auto angle = [](double tangent) { return static_cast<float>(std::atan(tangent)); };
  return {angle(sides.left), angle(sides.right), angle(sides.up), angle(sides.down)};
}

}  // namespace glissade::test
