#pragma once

#include "engine/base/parameters.h"
#include "engine/base/stop_token.h"
#include "engine/planning/path.h"
#include "engine/planning/problem.h"

namespace glissade {

/// A path to the goal "out" whose end is straight. From an early place on the path, the object moves straight out of
/// the obstacles' box, along its direction of motion there or along a likely direction (straight_ways_out.h), where
/// that is shorter than the rest of the path, in metres of the metric. A planner's path ends at the root of a goal
/// tree, which may be on the other side of the product.
///
/// The place is found by halving, as if every place after the first one with a straight way out had one. So it need not
/// be the first. The result is certified. Where there is none the path is returned unchanged.
Path withStraightEnd(const Path& path, const Problem& problem, const ParameterValues& parameters,
                     const StopToken& stop = {});

}  // namespace glissade
