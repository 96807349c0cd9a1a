#pragma once

#include <vector>

#include "engine/base/message.h"
#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/stated_units.h"

namespace glissade::cli {

/// The conditions of a plan in the judge's words. They are statements that the plan alone makes: bodies that it calls
/// a unit, or its base, and pitches that no standard thread of that diameter has and no person states.
std::vector<Message> conditionsOf(const AssemblyPlan& plan, const AssembledProduct& product, const StatedUnits& units);

}  // namespace glissade::cli
