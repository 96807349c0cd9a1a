#pragma once

#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// A box that holds the mesh on all of the path of its frame: straight motions between configurations.
Box3 sweptBox(const TriangleMesh& mesh, const std::vector<Pose>& path);

}  // namespace glissade
