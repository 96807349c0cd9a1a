#pragma once

#include <vector>

#include "engine/base/stop_token.h"
#include "engine/check/placed_body.h"

namespace glissade::check {

/// Metres: a larger overlap is a clash.
inline constexpr double kClashOverlap = 1e-3;

/// How deep the surface of one body is below the faces of another one.
struct Overlap {
  std::vector<double> depths;  ///< metres, of each region of the body; 0 where nothing is below it
  double deepest = 0.0;        ///< the largest of them
  double thickness = 0.0;      ///< of the body below its surface there, metres
};

/// The depth of a point of the other surface is its distance from the surface of the body. It counts for the region
/// that has the nearest point, where that faces the other surface. It is taken at points where it can be largest
/// (deepestPoints()), and nothing is added: what is not met is not allowed. The wall of a round hole that a shaft goes
/// through, tilted by up to 11 degrees, counts across the axis of the hole, unless the body with the shaft has a knob
/// beside it that a wider hole would let pass. Bodies that are not closed have no inside.
Overlap overlapIn(const PlacedBody& body, const PlacedBody& other, const StopToken& stop);

}  // namespace glissade::check
