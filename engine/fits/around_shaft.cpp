#include "engine/fits/around_shaft.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/fits/thread_pitch.h"

namespace glissade {
namespace {

/// A hole counts as wide as the shaft if it is wider by less than this share.
constexpr double kEqualShare = 0.02;
/// Least relative difference of the radii of a helix in one section.
constexpr double kHelixShare = 0.06;
/// Share of directions in which a body has to surround the shaft.
constexpr double kLeastAround = 0.55;
/// Least thickness of a surrounding body, in radii of the shaft; a thinner one is in the shaft rather than around it.
constexpr double kThickerThan = 1.15;
/// Least radius of the core of a thread, in radii of the shaft: screws for wood have 0.6.
constexpr double kNarrowestCore = 0.5;
/// Least length of a contact, in radii of the shaft.
constexpr double kLeastContact = 0.1;

/// Offset of a hole's centre from the axis in one section, and the radius of the hole.
struct HoleMiddle {
  Eigen::Vector2d offset = Eigen::Vector2d::Zero();
  double radius = 0.0;
};

HoleMiddle middleIn(const AxialSlab& slab) {
  HoleMiddle middle;
  int count = 0;
  for (std::size_t i = 0; i < slab.nearest.size(); ++i) {
    if (!std::isfinite(slab.nearest[i])) continue;
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / kAxialAngles;
    middle.offset += 2.0 * slab.nearest[i] * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    middle.radius += slab.nearest[i];
    ++count;
  }
  if (count == 0) return {};
  middle.offset /= count;
  middle.radius /= count;
  return middle;
}

/// Radius of a hole beside the axis that has the same offset in all sections; nothing if there is none. The centre of a
/// helix is on another side in each section.
std::optional<double> misplacedHole(const std::vector<AxialSlab>& slabs, double shaft) {
  Eigen::Vector2d offset = Eigen::Vector2d::Zero();
  double apart = 0.0;
  double radius = 0.0;
  int count = 0;
  int sections = 0;  // of the body
  for (const AxialSlab& slab : slabs) {
    if (slab.isSolid || slab.surroundedShare() > 0.0) ++sections;
    if (slab.isSolid || slab.surroundedShare() < 0.9) continue;
    const HoleMiddle middle = middleIn(slab);
    offset += middle.offset;
    apart += middle.offset.norm();
    radius = count == 0 ? middle.radius : std::min(radius, middle.radius);
    ++count;
  }
  constexpr double kOneSide = 0.9;
  constexpr double kLeastApart = 0.03;
  constexpr int kFewSections = 3;  // a plain hole has one or two sections, a helix many
  const bool isPlain = count > 0 && count == sections;
  if ((count < kFewSections && !isPlain) || apart < kLeastApart * shaft * count || offset.norm() < kOneSide * apart)
    return std::nullopt;
  return radius;
}

/// Radius of a hole in a section: the largest of a round hole, to ignore its tessellation; the crest of a helix.
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
  const std::vector<AxialSlab> slabs = body.slabsAbout(axis, reach);
  const auto misplaced = misplacedHole(slabs, radius);
  for (const AxialSlab& slab : slabs) {
    const bool isAround = slab.isSolid ? slab.surroundedShare() == 0.0 || slab.nearestAt(0.5) > kThickerThan * radius
                                       : slab.surroundedShare() >= kLeastAround;
    if (!isAround) continue;
    const double round = misplaced ? *misplaced : radiusIn(slab);
    const double hole = slab.isSolid ? 0.0 : round;
    if (slab.high <= shaft.low + 0.02 * radius) {
      isBeyond = isBeyond || hole < (1.0 - kEqualShare) * radius;
      continue;
    }
    around.low = std::min(around.low, slab.low);
    around.high = std::max(around.high, slab.high);
    around.hole = std::min(around.hole, hole);
    around.surround += slab.length();
    around.solid += slab.isSolid ? slab.length() : 0.0;
    const bool isTight = isThreadDepth(radius, radius - hole);
    const bool isEqual = !isTight && hole <= (1.0 + kEqualShare) * radius;
    around.tight += isTight ? slab.length() : 0.0;
    around.threaded += isTight && hole >= kNarrowestCore * radius ? slab.length() : 0.0;
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
