#pragma once

#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// The core of a shaft that a thread is modelled on: the cylinder that is left where the thread is taken away.
struct ThreadCore {
  Vector3 point = Vector3::Zero();  ///< on the axis, in the frame of the mesh
  Vector3 direction = Vector3::UnitZ();
  double radius = 0.0;  ///< metres

  double distanceOf(const Vector3& p) const { return (p - point).cross(direction).norm(); }
};

/// Of each triangle: whether it is of the thread. It has an allowance, and its farthest corner is beyond the core by no
/// more than the largest allowance. What is in a tooth is nearer to its flanks than to its crest. So the faces of a
/// tooth count together, and a face that the file states is of the thread, too, where the corners of two thirds of its
/// triangles are corners of such triangles: the crest is a strip between two flanks. `allowances`: of each triangle,
/// metres.
std::vector<bool> trianglesOfThread(const TriangleMesh& mesh, const std::vector<double>& allowances,
                                    const ThreadCore& core);

/// Takes the thread away: adds to the moves of the corners of its triangles that are beyond the core what leads them
/// onto it, across the axis. `moves`: of each vertex.
void moveOntoCore(const TriangleMesh& mesh, const std::vector<bool>& ofThread, const ThreadCore& core,
                  std::vector<Vector3>& moves);

}  // namespace glissade
