#pragma once

#include <optional>

#include "engine/fits/contact_report.h"
#include "engine/fits/surface_regions.h"
#include "engine/geometry/triangle_pair.h"

namespace glissade {

/// The exact relation of two stated or fitted surfaces; it does not depend on tessellation.
struct RegionPair {
  enum class Kind {
    Planes,
    Coaxial,  ///< cylinders: a shaft in a hole
    Tangent,
    Nested  ///< cones, spheres or tori at a constant distance
  };
  Kind kind = Kind::Planes;
  double gap = 0.0;                   ///< metres; negative: they overlap
  std::optional<ContactAxis> axis{};  ///< for Coaxial, and for cones
  double radius = 0.0;  ///< for Nested, metres: radius of the inner sphere or tube, or of the inner cone at its middle
};

/// Compares planes that face each other, a shaft in a hole on one axis, a shaft along a plane or beside another shaft,
/// a cone in a cone of the same angle on one axis, a ball in a hollow sphere about the same centre or in a groove that
/// is a torus, and a torus in a torus about the same circle. Nothing for other pairs. Planes need not be beside each
/// other.
std::optional<RegionPair> compareRegions(const SurfaceRegions& a, const SurfaceRegions::Label& labelA,
                                         const SurfaceRegions& b, const SurfaceRegions::Label& labelB);

/// True if triangles of planes that face each other overlap in the projection along the normal of `a`.
bool overlapInPlane(const Triangle& a, const Triangle& b, const PlaneRegion& plane);

}  // namespace glissade
