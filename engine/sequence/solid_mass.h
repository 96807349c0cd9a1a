#pragma once

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// Volume and centre of the solid that a closed mesh encloses. For an open mesh, or one without volume: zero volume and
/// the centre of the bounding box.
struct SolidMass {
  double volume = 0.0;  ///< cubic metres, >= 0
  Vector3 centre = Vector3::Zero();
};

/// Sums signed tetrahedra about the centre of the bounding box.
SolidMass solidMass(const TriangleMesh& mesh);

}  // namespace glissade
