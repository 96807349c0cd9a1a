#pragma once

#include "engine/sequence/order_rules.h"

namespace glissade {

/// The set with all bodies that are bonded to a body of it.
BodySet withJoined(BodySet set, const std::vector<BodyGroup>& bonded);

/// Lets bodies that joints bond leave together, in addition to the groups that a person demands: groups with a body in
/// common are merged. A demand on a body holds for its whole group; a demanded motion is expressed in the frame of the
/// group.
void joinUnits(const std::vector<BodyGroup>& bonded, const AssembledProduct& product, OrderRules& rules);

}  // namespace glissade
