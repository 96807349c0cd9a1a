#pragma once

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// What a closed mesh encloses. Of an open one, or one without volume: no volume, and the middle of its bounding box.
struct SolidMass {
  double volume = 0.0;  ///< cubic metres, >= 0
  Vector3 centre = Vector3::Zero();
};

/// By signed tetrahedra about the middle of the bounding box.
SolidMass solidMass(const TriangleMesh& mesh);

}  // namespace glissade
