#pragma once

#include "engine/base/random_stream.h"
#include "engine/geometry/pose.h"

namespace glissade {

/// Position uniform in a cube of the given half width, orientation uniform.
inline Pose randomPose(RandomStream& stream, double halfWidth) {
  Pose pose;
  for (int i = 0; i < 3; ++i) pose.position[i] = stream.uniform(-halfWidth, halfWidth);
  pose.orientation = Quaternion(stream.normal(), stream.normal(), stream.normal(), stream.normal()).normalized();
  return pose;
}

}  // namespace glissade
