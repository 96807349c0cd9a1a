#pragma once

#include "engine/base/stop_token.h"
#include "engine/fits/joint.h"
#include "engine/fits/named_joints.h"
#include "engine/fits/product_shapes.h"

namespace glissade {

/// The screws and nuts of a product, by body. If the evidence is contradictory, such as a bolt in a nut of another
/// size, the joint is suggested and doubtful. `said`: designations by name; without a drive, a name decides whether a
/// shaft that fits its holes closely is a screw.
Joints findThreadedJoints(const ProductShapes& shapes, const Designations& said, const StopToken& stop);

}  // namespace glissade
