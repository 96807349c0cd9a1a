#pragma once

#include "engine/base/enum_names.h"
#include "engine/sequence/assembly_plan.h"

namespace glissade {

/// Names in files of assembly plans.
inline constexpr EnumNames<PlanEnd, 4> kPlanEndNames{{"complete", "stuck", "time_limit", "interrupted"}};
inline constexpr EnumNames<StepViolation::Rule, 5> kRuleNames{{"before", "fastener", "standing", "place", "joint"}};

}  // namespace glissade
