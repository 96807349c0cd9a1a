#pragma once

#include <string>

#include "engine/geometry/triangle_mesh.h"
#include "engine/model/body_id.h"

namespace glissade::evidence {

/// A body of a product, as the judge reads it.
struct Body {
  BodyId id;
  std::string name;         ///< name for people
  MeshPtr mesh;             ///< triangles in the body's frame B
  Pose X_WB;                ///< pose where the product is assembled
  double spacing = 0.0;     ///< largest deviation of a coordinate of the mesh from the file, metres
  double deflection = 0.0;  ///< largest deviation of curved triangles, metres, for a mesh without faces
};

}  // namespace glissade::evidence
