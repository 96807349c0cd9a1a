#pragma once

#include <optional>

#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/body_group.h"

namespace glissade {

/// Which way a plan is told and played: removal as it was searched, or assembly, its reverse.
enum class PlanOrder { Removal, Assembly };

/// The bodies that leave together in a step, by index in the product. Precondition: the plan is about the product.
std::vector<std::size_t> bodiesOf(const AssemblyStep& step, const AssembledProduct& product);

/// The same plan with the ids of the product's bodies, in their order. A body of the plan is the body of that id or, in
/// a scenario that was made of the product's file, of that name. Nothing where the two have other bodies.
std::optional<AssemblyPlan> planAbout(const AssembledProduct& product, const AssemblyPlan& plan);

}  // namespace glissade
