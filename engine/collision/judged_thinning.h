#pragma once

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// The independent check's own construction of a thinned body, after the definition at ThinnableMesh. Shares nothing
/// with it. Slow and simple. The mesh itself where the body cannot be
/// thinned. Allowance: metres, > 0.
TriangleMesh thinnedForJudging(const TriangleMesh& mesh, double allowance);

}  // namespace glissade
