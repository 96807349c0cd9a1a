#pragma once

#include <optional>

#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/body_group.h"

namespace glissade {

/// The order in which a plan is described and played: removal as it was searched, or its reverse, assembly.
enum class PlanOrder { Removal, Assembly };

/// The bodies that leave in a step, by index in the product. Precondition: the plan belongs to the product.
std::vector<std::size_t> bodiesOf(const AssemblyStep& step, const AssembledProduct& product);

/// The motions of a step in this order.
std::vector<const StepMotion*> motionsOf(const AssemblyStep& step, PlanOrder order);

/// All motions of the plan and of the lines of its groups.
std::vector<const StepMotion*> allMotionsOf(const AssemblyPlan& plan);

/// The allowances of a motion against bodies that are there when the steps are carried out in their order; a motion
/// also states those of other orders (addPrecedence()). `at`: index of its step. Precondition: the motion is one of the
/// step.
std::vector<Allowance> allowancesInOrder(const std::vector<AssemblyStep>& steps, std::size_t at,
                                         const StepMotion& motion);

/// The plan with the ids and the order of the product's bodies. A body of the plan is the body with the same id, or the
/// same name if the scenario was made from the product's file. Nothing if the two have different bodies.
std::optional<AssemblyPlan> planAbout(const AssembledProduct& product, const AssemblyPlan& plan);

}  // namespace glissade
