#pragma once

#include "engine/base/stop_token.h"
#include "engine/product/joint.h"
#include "engine/product/named_joints.h"
#include "engine/product/product_shapes.h"

namespace glissade {

/// The screws and nuts of a product, by body. Where the evidence contradicts itself, as a bolt in a nut of another size
/// does, the joint is suggested and doubtful. `said`: by the names; without a drive, a name decides whether a shaft
/// that only just fits its holes is a screw.
Joints findThreadedJoints(const ProductShapes& shapes, const Designations& said, const StopToken& stop);

}  // namespace glissade
