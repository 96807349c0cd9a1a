#pragma once

#include <vector>

#include "engine/base/message.h"
#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/stated_units.h"

namespace glissade::cli {

/// What a plan states itself and the judge makes a condition of, in the judge's words: bodies that only the plan calls
/// a unit, or its base, and pitches that no standard thread of that diameter has and no person states.
std::vector<Message> conditionsOf(const AssemblyPlan& plan, const AssembledProduct& product, const StatedUnits& units);

}  // namespace glissade::cli
