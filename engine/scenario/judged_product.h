#pragma once

#include <optional>

#include "engine/check/path_verdict.h"
#include "engine/check/plan_verdict.h"
#include "engine/scenario/scenario.h"
#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/body_group.h"

namespace glissade {

// What is loaded already, as the judge takes it: nothing is read again. The judge decides by itself.

std::vector<check::Body> judgedBodies(const std::vector<RigidBody>& bodies);
check::Product judgedProduct(const AssembledProduct& product);
check::Plan judgedPlan(const AssemblyPlan& plan);
/// Without what a person forbids, which is in the scenario's file.
check::Question judgedQuestion(const LoadedScenario& scenario);
/// The path states these fits.
check::Path judgedPath(const std::vector<PathPoint>& points, const LoadedScenario& scenario);

/// `required`: clearance, metres; nothing: the usual one for the size of each body. `said`: by a person of the product,
/// so that what the plan says beside it is a condition; null: nothing.
check::PlanVerdict judgePlan(const AssemblyPlan& plan, const AssembledProduct& product, std::optional<double> required,
                             const WorkWatch& watch = {}, const SequenceDemands* said = nullptr);

}  // namespace glissade
