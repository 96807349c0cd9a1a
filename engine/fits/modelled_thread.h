#pragma once

#include <vector>

#include "engine/geometry/screw_axis.h"
#include "engine/places/rigid_body.h"

namespace glissade {

/// A thread that is modelled in the meshes of the object and an obstacle, found where they are engaged.
struct ModelledThread {
  ScrewAxis screw;
  double objectLow = 0.0;  ///< range of the object's thread along the axis, from the axis' point, where it was found
  double objectHigh = 0.0;
  double obstacleLow = 0.0;  ///< range of the obstacle's thread
  double obstacleHigh = 0.0;
};

/// The threads in which the object is engaged at this configuration: surfaces of both bodies that are near each other
/// and that the same screw motion moves along themselves. One entry each for the axis of the obstacle, that of the
/// object, and the middle of both, which differ by the play; empty if there is none. `apart`: distance of the two,
/// metres.
std::vector<ModelledThread> findModelledThreads(const TriangleMesh& object, const Pose& at, const RigidBody& obstacle,
                                                double apart);

}  // namespace glissade
