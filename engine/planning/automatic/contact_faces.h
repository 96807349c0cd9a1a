#pragma once

#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// The outward normals of the object's largest faces, in its frame, sorted by falling area of all triangles that share
/// them; at most `count`. Planners derive contact faces and directions of disassembly from them.
std::vector<Vector3> largestFaceNormals(const TriangleMesh& mesh, std::size_t count);

}  // namespace glissade
