#pragma once

#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// Boxes, world coordinates, outside which a body covers the same points before and after a motion.
///
/// A triangle that goes from one place to another changes what lies in the box of its six vertices at
/// most: elsewhere the surface does not pass while the vertices go straight, so that no point changes
/// sides. A triangle that slides in its own plane changes nothing but where the rim of its flat face
/// goes. Only planes across a coordinate axis count as the same plane, since they alone are the same
/// to the last bit: a box that slides along an axis changes at its two ends.
///
/// Precondition: the meshes have the same triangles.
std::vector<Box3> changedBoxes(const TriangleMesh& before_W, const TriangleMesh& after_W);

}  // namespace glissade
