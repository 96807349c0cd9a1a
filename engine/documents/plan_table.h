#pragma once

#include <string>

#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/plan_bodies.h"

namespace glissade {

/// The steps of a plan as CSV, one line for each step in the given order, lengths in metres: step (its number in the
/// order of assembly), part, method, motion (in English), length, turn, proved clearance, smallest clearance, nearest
/// part, largest allowance, wave, blocked by (empty), tool, and the parts that must be held. Parts for which no motion
/// was found follow without a number, with the parts that block them. Precondition: the plan is about this product.
std::string planAsCsv(const AssemblyPlan& plan, const AssembledProduct& product, PlanOrder order);

}  // namespace glissade
