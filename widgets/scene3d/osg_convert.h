#pragma once

#include <osg/Matrixd>
#include <osg/Vec3>
#include <osg/Vec4>

#include "engine/geometry/pose.h"
#include "engine/places/rigid_body.h"

namespace glissade {

inline osg::Vec3 toOsg(const Vector3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

inline osg::Vec4 toOsg(const Colour& colour, double alpha = 1.0) {
  return {static_cast<float>(colour[0]), static_cast<float>(colour[1]), static_cast<float>(colour[2]),
          static_cast<float>(alpha)};
}

/// Converts a pose. OSG multiplies row vectors from the left: p' = p * M, with the translation in the last row.
inline osg::Matrixd toOsg(const Pose& X_WB) {
  const Eigen::Matrix3d R = X_WB.orientation.toRotationMatrix();
  const Vector3& p = X_WB.position;
  return {R(0, 0), R(1, 0), R(2, 0), 0.0, R(0, 1), R(1, 1), R(2, 1), 0.0,
          R(0, 2), R(1, 2), R(2, 2), 0.0, p.x(),   p.y(),   p.z(),   1.0};
}

}  // namespace glissade
