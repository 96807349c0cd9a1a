#include "engine/product/around_shaft.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

/// Holes whose radius is within this share of the shaft's are as wide as it.
constexpr double kEqualShare = 0.02;
/// Of a helix, a hole has different radii in one section.
constexpr double kHelixShare = 0.06;
/// Directions in which a body has to be around the shaft.
constexpr double kLeastAround = 0.55;
/// What is thinner than this, by the shaft's radius, is in the shaft rather than around it.
constexpr double kThickerThan = 1.15;
/// A contact of this length counts, by the shaft's radius.
constexpr double kLeastContact = 0.1;

/// The radius of a hole in a section: of a round one all that tessellation leaves, of a helix its crest.
double radiusIn(const AxialSlab& slab) {
  const double wide = slab.nearestAt(0.95);
  const double narrow = slab.nearestAt(0.1);
  return wide - narrow > kHelixShare * wide ? narrow : wide;
}

}  // namespace

std::optional<AroundShaft> aroundShaft(const AxialMesh& body, const AxisLine& axis, const TurnedShape& shaft) {
  const double radius = shaft.shaft;
  const AxialReach reach{shaft.low - 0.5 * radius, shaft.headLow + 0.05 * radius, kAroundReach * radius};
  AroundShaft around;
  around.low = reach.high;
  around.high = reach.low;
  around.hole = reach.radius;
  around.tightLow = reach.high;
  around.tightHigh = reach.low;
  bool isBeyond = false;
  for (const AxialSlab& slab : body.slabsAbout(axis, reach)) {
    const bool isAround = slab.isSolid ? slab.surroundedShare() == 0.0 || slab.nearestAt(0.5) > kThickerThan * radius
                                       : slab.surroundedShare() >= kLeastAround;
    if (!isAround) continue;
    const double hole = slab.isSolid ? 0.0 : radiusIn(slab);
    if (slab.high <= shaft.low + 0.02 * radius) {
      isBeyond = isBeyond || hole < (1.0 - kEqualShare) * radius;
      continue;
    }
    around.low = std::min(around.low, slab.low);
    around.high = std::max(around.high, slab.high);
    around.hole = std::min(around.hole, hole);
    around.surround += slab.length();
    const bool isTight = hole < (1.0 - kEqualShare) * radius;
    const bool isEqual = !isTight && hole <= (1.0 + kEqualShare) * radius;
    around.tight += isTight ? slab.length() : 0.0;
    around.equal += isEqual ? slab.length() : 0.0;
    if (!isTight && !isEqual) continue;
    around.tightLow = std::min(around.tightLow, slab.low);
    around.tightHigh = std::max(around.tightHigh, slab.high);
  }
  if (around.surround <= kLeastContact * radius) return std::nullopt;
  if (around.tight < kLeastContact * radius) around.tight = 0.0;
  if (around.equal < kLeastContact * radius) around.equal = 0.0;
  around.isBlind = isBeyond;
  return around;
}

}  // namespace glissade
