#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace glissade::api {

/// A point or a direction, metres.
using Vector3 = Eigen::Matrix<double, 3, 1, Eigen::DontAlign>;
/// A rotation.
using Quaternion = Eigen::Quaternion<double, Eigen::DontAlign>;

/// A rigid transform X_AB: it takes coordinates in frame B to coordinates in frame A. A configuration of the object is
/// X_WB, the pose of its frame B in the world W.
///
/// The engine's own pose has an aligned quaternion, whose layout depends on the instruction set that a program is
/// compiled for. This one has the same layout in every program.
struct Pose {
  Vector3 position = Vector3::Zero();               ///< metres
  Quaternion orientation = Quaternion::Identity();  ///< unit
};

/// An axis-aligned box in the world, metres.
struct Box {
  Vector3 lower = Vector3::Zero();  ///< corner of the least coordinates
  Vector3 upper = Vector3::Zero();  ///< corner of the largest coordinates
};

}  // namespace glissade::api
