#pragma once

#include <string>
#include <vector>

#include "app/cli/report.h"
#include "engine/sequence/assembly_plan.h"

namespace glissade::cli {

/// The shown names of the bodies in this order.
std::string namesOf(const std::vector<BodyId>& ids, const AssembledProduct& product, const char* separator);

/// Prints the steps of a plan, what is stuck, and how many parts are removed. `seconds`: time of the planning.
void printPlan(const AssemblyPlan& plan, const AssembledProduct& product, double seconds, const Console& console);

}  // namespace glissade::cli
