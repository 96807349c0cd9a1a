#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/product/assembled_product.h"
#include "engine/product/joint.h"

namespace glissade {

/// What a joint of these bodies may be, for a person to change: the kind by the shape of the body that leaves, its
/// axis, and a thread by its radius. `body`: the one that leaves; nothing: the smallest. Precondition: `bodies` is not
/// empty.
Joint draftJoint(const AssembledProduct& product, const std::vector<std::size_t>& bodies,
                 std::optional<std::size_t> body = std::nullopt);

/// A person's word that this joint is there. What its kind has no use for is left out.
JointEdit wordThatMakes(Joint joint, const AssembledProduct& product);

}  // namespace glissade
