#pragma once

#include <string>
#include <vector>

#include "engine/check/placed_body.h"

namespace glissade::check {

/// A pair of bodies, the one of which leaves the other.
struct LeavingPair {
  const PlacedBody& moving;       ///< where the product is assembled
  const PlacedBody& other;        ///< likewise
  const std::vector<Pose>& path;  ///< of the moving body, from there
  double overlap = 0.0;           ///< metres, as deep as the one is in the other
  bool isCalledThread = false;    ///< by the file: also where both cylinders are equally wide
};

/// A share of the shaft's radius: what is thicker than its hole by more is neither pressed nor slid in. Threads are
/// deeper, those of ISO 261 by 0.06 radii or more, and none by 0.3. The bodies overlap by half of that depth or more:
/// else the one cylinder is around the material of the other.
inline constexpr double kLeastThreadDepth = 0.05;
inline constexpr double kMostThreadDepth = 0.3;

/// How much of a thread a motion pulls instead of turning the body off, for people; empty: nothing. A thread is a shaft
/// of the one in a hole of the other, with all of the hole's wall in the shaft. While the two are around each other,
/// the body turns about the axis and advances by the same pitch in each turn; the last pitch may be pulled, because a
/// thread ends in its run-out.
std::string pulledThread(const LeavingPair& pair);

}  // namespace glissade::check
