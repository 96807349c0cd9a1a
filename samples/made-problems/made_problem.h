#pragma once

#include <string>
#include <vector>

#include "engine/geometry/pose.h"
#include "engine/geometry/primitives.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade::made {

/// One of the project's own problems. Metres, z up.
struct MadeProblem {
  std::string name;
  std::string description;
  TriangleMesh object;
  TriangleMesh obstacles;
  Pose start;
  Pose goal;
  Box3 workspace;
};

inline TriangleMesh boxBetween(const Vector3& least, const Vector3& most) {
  return transformed(makeBox(most - least), Pose::translation((least + most) / 2.0));
}

inline Pose turnedAt(const Vector3& position, double angle, const Vector3& axis) {
  return {position, Quaternion(Eigen::AngleAxisd(angle, axis.normalized()))};
}

}  // namespace glissade::made
