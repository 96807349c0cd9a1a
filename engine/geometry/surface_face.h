#pragma once

#include <cstdint>

#include "engine/geometry/pose.h"

namespace glissade {

/// Geometry that a file states for one face of a meshed surface. Lengths in metres, in the frame of the mesh.
struct SurfaceFace {
  enum class Kind : std::uint8_t { Free, Plane, Cylinder, Cone, Sphere, Torus };
  Kind kind = Kind::Free;
  Vector3 point = Vector3::Zero();  ///< point on the plane or on the axis; centre of a sphere or a torus
  Vector3 axis = Vector3::UnitZ();  ///< unit normal of a plane, else unit axis
  double radius = 0.0;              ///< radius of a cylinder, of a sphere, of a cone at `point`, or of a torus's circle
  double second = 0.0;              ///< half of a cone's opening angle, radians; radius of a torus's tube
  /// Largest distance of the face's triangles from its surface, metres; measured when the file is read.
  double deflection = 0.0;
};

/// The face placed at X_AB.
SurfaceFace transformed(const SurfaceFace& face, const Pose& X_AB);

}  // namespace glissade
