#pragma once

#include <string>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/fits/joint.h"
#include "engine/fits/product_shapes.h"

namespace glissade {

/// The joints of a product that can be found without a person: screws, nuts, inserts, pins and rolling bearings are
/// recognised by shape; others are suggested by name, class and shape. Ordered by body, then by kind; the same product
/// gives the same joints. After a stop the list is incomplete. `classes`: the class of each body, empty for none; an
/// empty vector if classes are not known. See engine/fits/README.md for the evidence of each kind.
Joints findJoints(const AssembledProduct& product, const StopToken& stop = {},
                  const std::vector<std::string>& classes = {});
/// For shapes that other callers use, too.
Joints findJoints(const ProductShapes& shapes, const StopToken& stop = {},
                  const std::vector<std::string>& classes = {});

}  // namespace glissade
