#pragma once

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// The mesh with its surface moved inwards by `depth` (metres; negative: outwards): every vertex goes
/// to where the moved planes of its faces meet, in the least squares' sense where there are more than
/// three of them. Where the body is thin it keeps a fifth of its thickness. For searches in an easier
/// space only: sharp edges move by less than they should, and the result may intersect itself.
/// Cost: triangles squared.
TriangleMesh eroded(const TriangleMesh& mesh, double depth);

}  // namespace glissade
