#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/fits/assembled_product.h"
#include "engine/fits/joint.h"

namespace glissade {

/// A proposal for a joint of these bodies, which a person can change: its kind by the shape of the body that leaves,
/// its axis, and a thread by its radius. `body`: the body that leaves; nothing: the smallest. Precondition: `bodies` is
/// not empty.
Joint draftJoint(const AssembledProduct& product, const std::vector<std::size_t>& bodies,
                 std::optional<std::size_t> body = std::nullopt);

/// The edit by which a person states that this joint exists, without values that its kind does not use.
JointEdit editForJoint(Joint joint, const AssembledProduct& product);

}  // namespace glissade
