#pragma once

#include <vector>

#include "engine/base/stop_token.h"
#include "engine/check/placed_body.h"

namespace glissade::check {

/// How deep the surface of one body is below the faces of another one.
struct Overlap {
  std::vector<double> depths;  ///< metres, of each region of the body; 0 where nothing is below it
  double deepest = 0.0;        ///< the largest of them
  double thickness = 0.0;      ///< of the body below its surface there, metres
};

/// The depth of a point below a region is its distance from the surface of the body, where the region has the nearest
/// point of that. The surface of `other` is divided where it is not shown that its parts are no deeper than what was
/// met below the regions next to them, to a hundredth or a tenth of a micrometre. What is met is raised by that much.
/// Bodies that are not closed have no inside. Where a search ends early (very many small faces, a stop), what was met
/// counts: then less is allowed.
Overlap overlapIn(const PlacedBody& body, const PlacedBody& other, const StopToken& stop);

}  // namespace glissade::check
