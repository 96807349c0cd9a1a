#pragma once

#include <optional>

#include "engine/geometry/triangle_pair.h"
#include "engine/product/contact_report.h"
#include "engine/product/surface_regions.h"

namespace glissade {

/// How two fitted surfaces lie to each other, exactly: no tessellation enters.
struct RegionPair {
  enum class Kind { Planes, Coaxial, Tangent };
  Kind kind = Kind::Planes;
  double gap = 0.0;  ///< metres; negative: they overlap
  ContactAxis axis;  ///< of Coaxial
};

/// Planes that face each other, a shaft in a hole on one axis, a shaft along a plane or beside another shaft; nothing
/// of other pairs. That they are beside each other (not one behind the other) is not asked.
std::optional<RegionPair> compareRegions(const SurfaceRegions& a, const SurfaceRegions::Label& labelA,
                                         const SurfaceRegions& b, const SurfaceRegions::Label& labelB);

/// Triangles of planes that face each other have a point in common when seen along the normal of `a`.
bool overlapInPlane(const Triangle& a, const Triangle& b, const PlaneRegion& plane);

}  // namespace glissade
