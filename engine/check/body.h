#pragma once

#include <string>

#include "engine/geometry/triangle_mesh.h"

namespace glissade::check {

/// A body of a product as the judge takes it.
struct Body {
  std::string id;
  std::string name;         ///< for people
  MeshPtr mesh;             ///< in the body's frame B
  Pose X_WB;                ///< where the product is assembled
  double spacing = 0.0;     ///< metres that a coordinate of the mesh may be off its file
  double deflection = 0.0;  ///< metres that curved triangles may be off the surface, where the mesh has no faces
};

}  // namespace glissade::check
