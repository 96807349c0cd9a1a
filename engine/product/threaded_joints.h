#pragma once

#include "engine/base/stop_token.h"
#include "engine/product/joint.h"
#include "engine/product/product_shapes.h"

namespace glissade {

/// The screws and nuts of a product, by body.
Joints findThreadedJoints(const ProductShapes& shapes, const StopToken& stop);

}  // namespace glissade
