#pragma once

#include <cstdint>

#include "engine/geometry/pose.h"

namespace glissade {

/// What a file states of one face of the surface that a mesh stands for. Lengths in metres, in the frame of the mesh.
struct SurfaceFace {
  enum class Kind : std::uint8_t { Free, Plane, Cylinder, Cone, Sphere, Torus };
  Kind kind = Kind::Free;
  Vector3 point = Vector3::Zero();  ///< on the plane or on the axis; the centre of a sphere or a torus
  Vector3 axis = Vector3::UnitZ();  ///< unit: normal of a plane, else the axis
  double radius = 0.0;              ///< of a cylinder, a sphere, a cone at `point`, of a torus's circle
  double second = 0.0;              ///< half of a cone's opening angle, radians; radius of a torus's tube
  double deflection = 0.0;          ///< that the triangles of the face may be off its surface; measured on reading
};

/// The face placed at X_AB.
SurfaceFace transformed(const SurfaceFace& face, const Pose& X_AB);

}  // namespace glissade
