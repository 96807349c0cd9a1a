#pragma once

#include <vector>

#include "engine/base/stop_token.h"
#include "engine/evidence/placed_body.h"

namespace glissade::evidence {

/// Metres: a larger overlap is a clash.
inline constexpr double kClashOverlap = 1e-3;

/// Depth of one body's surface below the faces of another body.
struct Overlap {
  std::vector<double> depths;  ///< depth at each region of the body, metres; 0: none
  double deepest = 0.0;        ///< the largest depth, metres
  double thickness = 0.0;      ///< thickness of the body below its surface at the deepest point, metres
};

/// The depth of a point of the other surface is its distance from the surface of the body. It counts for the region
/// with the nearest point, if that faces the other surface. Depths are computed at points where they can be largest
/// (deepestPoints()); a depth that is not measured is not allowed. The wall of a round hole through which a tilted
/// shaft passes (up to 11 degrees) counts across the axis of the hole, unless the body with the shaft has a knob beside
/// it that a wider hole would let pass. Bodies that are not closed have no inside.
Overlap overlapIn(const PlacedBody& body, const PlacedBody& other, const StopToken& stop);

}  // namespace glissade::evidence
