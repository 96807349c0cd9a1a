#pragma once

#include <vector>

#include "engine/base/stop_token.h"
#include "engine/product/joint.h"
#include "engine/product/product_shapes.h"

namespace glissade {

/// The screws and nuts of a product, by body. `isScrewByName`: of each body; without a drive, it decides whether a
/// shaft that only just fits its holes is a screw.
Joints findThreadedJoints(const ProductShapes& shapes, const std::vector<bool>& isScrewByName, const StopToken& stop);

}  // namespace glissade
