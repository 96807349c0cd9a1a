#pragma once

#include <optional>

#include "engine/product/measurement.h"

namespace glissade {

/// The features can be put onto each other: two planes, or two cylinders.
bool canAlign(const MeasureFeature& moving, const MeasureFeature& fixed);

/// The least motion of the world, for the body of `moving`, that puts its plane onto that of `fixed` so that the two
/// faces look at each other, or its axis onto that of `fixed`, in the same direction or the opposite one, whichever is
/// nearer. It turns about the point that was picked (of a cylinder, the point of the axis beside it) and then moves
/// along the normal, or across the axis. `flipped`: the other direction. Both features in the world. Precondition:
/// canAlign().
Pose alignment(const MeasureFeature& moving, const MeasureFeature& fixed, bool flipped);

}  // namespace glissade
