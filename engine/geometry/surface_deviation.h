#pragma once

#include <array>

#include "engine/geometry/surface_face.h"

namespace glissade {

/// Signed distance of a point from the surface, metres; negative inside. A cone continues beyond its tip. Precondition:
/// the face is not Free.
double signedDistance(const SurfaceFace& face, const Vector3& p);

/// The largest distance of a point of the triangle from the surface, metres: exact for planes, cylinders, cones and
/// spheres; for a torus estimated from 45 samples and their second differences, a few percent too large. Precondition:
/// the face is not Free.
double deviationFrom(const SurfaceFace& face, const std::array<Vector3, 3>& corners);

}  // namespace glissade
