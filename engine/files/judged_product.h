#pragma once

#include <optional>

#include "engine/check/path_verdict.h"
#include "engine/check/plan_verdict.h"
#include "engine/files/scenario.h"
#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/body_group.h"

namespace glissade {

// Converts loaded data into the input of the judge without reading files again. The judge decides by itself.

std::vector<evidence::Body> judgedBodies(const std::vector<RigidBody>& bodies);
check::Product judgedProduct(const AssembledProduct& product);
check::Plan judgedPlan(const AssemblyPlan& plan);
/// The problem without the person's forbidden places, which are in the scenario's file.
check::Question judgedQuestion(const LoadedScenario& scenario);

/// `required`: clearance, metres; nothing: the default for the size of each body. `said`: a person's statements about
/// the product, so that other statements of the plan are conditions; null: none.
check::PlanVerdict judgePlan(const AssemblyPlan& plan, const AssembledProduct& product, std::optional<double> required,
                             const WorkWatch& watch = {}, const SequenceDemands* said = nullptr);

}  // namespace glissade
