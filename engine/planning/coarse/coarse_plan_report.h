#pragma once

#include "engine/planning/coarse/coarse_plan.h"
#include "engine/planning/planner.h"

namespace glissade {

/// Optional interface of planners that plan coarsely first.
class ReportsCoarsePlan {
 public:
  virtual ~ReportsCoarsePlan() = default;
  /// What the coarse planning decided; null before it did.
  virtual CoarsePlanPtr coarsePlan() const = 0;
};

/// Null for planners without a coarse planning.
inline CoarsePlanPtr coarsePlanOf(const Planner& planner) {
  const auto* report = reportOf<ReportsCoarsePlan>(planner);
  return report != nullptr ? report->coarsePlan() : nullptr;
}

}  // namespace glissade
