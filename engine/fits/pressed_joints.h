#pragma once

#include "engine/base/stop_token.h"
#include "engine/fits/joint.h"
#include "engine/fits/named_joints.h"
#include "engine/fits/product_shapes.h"

namespace glissade {

/// Inserts and pins of a product, by body. `threaded`: its screws and nuts; a ring with a thread in it is an insert
/// only if it fits its hole closely, and a screw is no pin. `said`: designations by name.
Joints findPressedJoints(const ProductShapes& shapes, const Joints& threaded, const Designations& said,
                         const StopToken& stop);

}  // namespace glissade
