#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/geometry/triangle_pair.h"

namespace glissade {

/// An oriented box in double precision. Columns of `axes` are its axes.
struct OrientedBox {
  Vector3 centre = Vector3::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Vector3 half = Vector3::Zero();

  double surface() const { return half.x() * half.y() + half.y() * half.z() + half.z() * half.x(); }
};

/// The smallest (by surface) of a few candidates around the corners: along the coordinate axes, the principal axes, and
/// the edges of the eight largest triangles with their normals.
OrientedBox fitBox(const std::vector<const Triangle*>& triangles);

/// Like fitBox() with fewer candidates; many triangles get a box along the coordinate axes. Takes a third of the time
/// for large meshes.
OrientedBox fitBoxQuickly(const std::vector<const Triangle*>& triangles);

}  // namespace glissade
