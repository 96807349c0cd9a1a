#pragma once

#include <array>

#include "engine/geometry/surface_face.h"

namespace glissade {

/// Distance of a point from the surface, metres; negative inside. Of a cone: from the one whose lines go on beyond the
/// tip. Precondition: the face is not Free.
double signedDistance(const SurfaceFace& face, const Vector3& p);

/// The largest distance of a point of the triangle from the surface, metres: exact for planes, cylinders, cones and
/// spheres; from 45 samples and their second differences for a torus, a few percent too large. Precondition: the face
/// is not Free.
double deviationFrom(const SurfaceFace& face, const std::array<Vector3, 3>& corners);

}  // namespace glissade
