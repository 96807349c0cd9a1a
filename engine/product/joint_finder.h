#pragma once

#include "engine/base/stop_token.h"
#include "engine/product/assembled_product.h"
#include "engine/product/joint.h"

namespace glissade {

/// What is known of the joints of a product without a person: screws, nuts, inserts, pins and rolling bearings are
/// recognised by shape; others are suggested. By body, then by kind; the same for the same product. After a stop the
/// list is incomplete. See engine/product/README.md for what is recognised by what.
Joints findJoints(const AssembledProduct& product, const StopToken& stop = {});

}  // namespace glissade
