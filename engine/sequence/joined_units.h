#pragma once

#include "engine/sequence/order_rules.h"

namespace glissade {

/// The set with all bodies that are one with a body of it.
BodySet withJoined(BodySet set, const std::vector<BodyGroup>& bonded);

/// Bodies that joints make one leave together, beside what a person demands: groups with a body in common become one.
/// What is demanded of a step's bodies is demanded of the whole group; a demanded motion goes on in the frame of the
/// group.
void joinUnits(const std::vector<BodyGroup>& bonded, const AssembledProduct& product, OrderRules& rules);

}  // namespace glissade
