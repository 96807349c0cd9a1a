#pragma once

#include "engine/planning/coarse/coarse_plan.h"
#include "engine/planning/planner.h"

namespace glissade {

/// Optional interface of planners that plan coarsely first.
class ReportsCoarsePlan {
 public:
  virtual ~ReportsCoarsePlan() = default;
  /// The decisions of the coarse planning; null before it.
  virtual CoarsePlanPtr coarsePlan() const = 0;
};

/// The planner's coarse plan; null for planners without a coarse planning.
inline CoarsePlanPtr coarsePlanOf(const Planner& planner) {
  const auto* report = reportOf<ReportsCoarsePlan>(planner);
  return report != nullptr ? report->coarsePlan() : nullptr;
}

}  // namespace glissade
