#pragma once

#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// Boxes, world coordinates, outside which a body covers the same points before and after a motion.
///
/// A triangle that moves changes at most the content of the box of its six vertices: the surface passes no other point
/// while the vertices move straight, so that no point elsewhere changes sides. A triangle that slides in its own plane
/// changes only the points that the rim of its flat face passes. Only planes perpendicular to a coordinate axis count
/// as the same plane, since only these are equal to the last bit. So a box that slides along an axis changes at its two
/// ends.
///
/// Precondition: the meshes have the same triangles.
std::vector<Box3> changedBoxes(const TriangleMesh& before_W, const TriangleMesh& after_W);

}  // namespace glissade
