#pragma once

#include <openxr/openxr.h>

#include "engine/geometry/pose.h"

namespace glissade {

inline Pose poseOf(const XrPosef& pose) {
  const Quaternion orientation(pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z);
  return {Vector3(pose.position.x, pose.position.y, pose.position.z), orientation.normalized()};
}

}  // namespace glissade
