#pragma once

#include <string>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/product/joint.h"
#include "engine/product/product_shapes.h"

namespace glissade {

/// What is known of the joints of a product without a person: screws, nuts, inserts, pins and rolling bearings are
/// recognised by shape; others are suggested by name, class and shape. By body, then by kind; the same for the same
/// product. After a stop the list is incomplete. `classes`: the class of each body, empty where it has none; none at
/// all where classes are not known. engine/product/README.md says what is recognised by what.
Joints findJoints(const AssembledProduct& product, const StopToken& stop = {},
                  const std::vector<std::string>& classes = {});
/// The same, of shapes that others look at, too.
Joints findJoints(const ProductShapes& shapes, const StopToken& stop = {},
                  const std::vector<std::string>& classes = {});

}  // namespace glissade
