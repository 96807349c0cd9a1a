#pragma once

#include "engine/base/stop_token.h"
#include "engine/fits/joint.h"
#include "engine/fits/product_shapes.h"

namespace glissade {

/// Rolling bearings that are drawn with their balls or rollers: two coaxial rings with at least three equal balls, or
/// five equal rollers, between them, and their cages and shields. Each is a unit.
Joints findRollingBearings(const ProductShapes& shapes, const StopToken& stop);

}  // namespace glissade
