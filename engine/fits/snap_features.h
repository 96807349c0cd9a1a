#pragma once

#include <cstddef>
#include <vector>

#include "engine/fits/measurement.h"

namespace glissade {

/// A plane or an axis of a body to which moved bodies snap.
struct SnapFeature {
  enum class Kind { Plane, Axis };
  Kind kind = Kind::Plane;
  Vector3 point = Vector3::Zero();       ///< the middle of the face, or of the axis
  Vector3 direction = Vector3::UnitZ();  ///< unit: the outward normal, or along the axis
  Box3 box;                              ///< box of the face, or of the part of the axis inside its cylinders and cones
  std::size_t triangle = 0;              ///< a triangle of the face or the round surface
};

/// The feature of a body at X_WB in the world.
SnapFeature placed(const SnapFeature& feature, const Pose& X_WB);

/// The planes and axes of a mesh that a person is likely to mean, in the mesh's frame: the largest planes, and the
/// longest axes. Cylinders and cones with one axis are one feature. Tori, which mostly round edges, count only in a
/// mesh without another axis. Small faces are left out, because a body would snap to them everywhere.
std::vector<SnapFeature> findSnapFeatures(const MeasurableMesh& mesh);

}  // namespace glissade
