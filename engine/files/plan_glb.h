#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/plan_bodies.h"

namespace glissade {

/// The whole plan as an animated GLB file (glTF 2.0). The steps follow each other; each takes two seconds at constant
/// speed in the metric of its body. In the order of assembly the motions are reversed. Bodies that have left stay where
/// their motion ends. Precondition: the plan is about the product. Errors: a position beyond single precision, more
/// triangles than GLB can hold.
Result<std::string> planAsGlb(const AssemblyPlan& plan, const AssembledProduct& product, PlanOrder order,
                              const std::string& name);

}  // namespace glissade
