#pragma once

#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// A box that contains the mesh along the path of its frame, with straight motions between configurations.
Box3 sweptBox(const TriangleMesh& mesh, const std::vector<Pose>& path);

}  // namespace glissade
