#pragma once

#include "engine/base/parameters.h"
#include "engine/base/stop_token.h"
#include "engine/planning/path.h"
#include "engine/planning/problem.h"

namespace glissade {

/// A path to the goal "out" that leaves straight as soon as it can: from an early place on it, the object goes straight
/// out of the obstacles' box, along the way that it goes there or a likely direction (straight_ways_out.h), where that
/// is shorter than the rest of the path, in metres of the metric. Planners end where one of the goal's trees begins,
/// which may be on the other side of the product.
///
/// The place is found by halving, as if a straight way out existed at all places after the first one that has it. So it
/// need not be the first. The result is certified; where there is none the path comes back as it was.
Path withStraightEnd(const Path& path, const Problem& problem, const ParameterValues& parameters,
                     const StopToken& stop = {});

}  // namespace glissade
