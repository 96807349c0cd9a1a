#pragma once

#include <vector>

#include "engine/fits/assembled_product.h"
#include "engine/fits/joint.h"
#include "engine/sequence/body_group.h"

namespace glissade {

/// A body that stays because a joint bonds it to another body that stays.
struct HeldByBase {
  BodyId body;                         ///< id
  JointKind kind = JointKind::Insert;  ///< Insert, Permanent or Unit
  BodyId with;                         ///< id of the body that it is bonded to
};

/// The bodies of `staying` that joints bond to one of `fixed`, or else to the largest body that stays. `joints`: those
/// that count.
std::vector<HeldByBase> heldByBase(const AssembledProduct& product, const Joints& joints, const BodySet& staying,
                                   const BodySet& fixed);

}  // namespace glissade
