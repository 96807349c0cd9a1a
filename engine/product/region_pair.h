#pragma once

#include <optional>

#include "engine/geometry/triangle_pair.h"
#include "engine/product/contact_report.h"
#include "engine/product/surface_regions.h"

namespace glissade {

/// How two surfaces that are stated or fitted lie to each other, exactly: no tessellation enters.
struct RegionPair {
  enum class Kind {
    Planes,
    Coaxial,  ///< cylinders, a shaft in a hole
    Tangent,
    Nested  ///< cones, spheres or tori, everywhere equally far from each other
  };
  Kind kind = Kind::Planes;
  double gap = 0.0;                   ///< metres; negative: they overlap
  std::optional<ContactAxis> axis{};  ///< of Coaxial, and of cones
  double radius = 0.0;  ///< metres, of Nested: of the inner sphere or tube; of the inner cone in the middle
};

/// Planes that face each other, a shaft in a hole on one axis, a shaft along a plane or beside another shaft, a cone in
/// a cone of the same angle on one axis, a ball in a hollow sphere about the same centre or in a groove that is a
/// torus, a torus in a torus about the same circle; nothing of other pairs. That they are beside each other (not one
/// behind the other) is not asked of planes.
std::optional<RegionPair> compareRegions(const SurfaceRegions& a, const SurfaceRegions::Label& labelA,
                                         const SurfaceRegions& b, const SurfaceRegions::Label& labelB);

/// Triangles of planes that face each other have a point in common when seen along the normal of `a`.
bool overlapInPlane(const Triangle& a, const Triangle& b, const PlaneRegion& plane);

}  // namespace glissade
