#pragma once

#include <cstddef>
#include <vector>

#include "engine/product/measurement.h"

namespace glissade {

/// A plane or an axis of a body that other bodies snap to while they are moved.
struct SnapFeature {
  enum class Kind { Plane, Axis };
  Kind kind = Kind::Plane;
  Vector3 point = Vector3::Zero();       ///< the middle of the face, or of the axis
  Vector3 direction = Vector3::UnitZ();  ///< unit: the outward normal, or along the axis
  Box3 box;                              ///< of the face, or of the part of the axis inside its cylinders and cones
  std::size_t triangle = 0;              ///< one of the face's, or of the round surface's
};

/// The feature of a body at X_WB in the world.
SnapFeature placed(const SnapFeature& feature, const Pose& X_WB);

/// The planes and axes of a mesh that a person means, in the mesh's frame: the largest planes, and the longest axes.
/// Cylinders and cones with one axis are one feature. Tori, which mostly round edges, count where a mesh has no other
/// axis. Small faces, which would make a body snap everywhere, are left out.
std::vector<SnapFeature> findSnapFeatures(const MeasurableMesh& mesh);

}  // namespace glissade
