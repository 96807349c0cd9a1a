#pragma once

#include <memory>

#include "engine/api/values.h"
#include "engine/session/session.h"

namespace glissade::api {

/// A run that has not begun.
struct PreparedRun {
  glissade::Problem problem;
  bool isFromOutside = false;  ///< its planner is one of PlanOptions::planners
  std::unique_ptr<LockstepSession> session{};
};
using PreparedRunPtr = std::shared_ptr<PreparedRun>;

/// Prepares a run of a problem or a scenario. Errors (Usage): an unknown strategy, operator or parameter, a value out
/// of its range.
Result<PreparedRunPtr> preparedRun(const Problem& problem, const PlanOptions& options);
Result<PreparedRunPtr> preparedRun(const Scenario& scenario, const PlanOptions& options);

RunCounts publicCounts(const PlannerCounts& counts);

/// The certified path of a run, or the reason why it has none. A run whose operator has failed has none.
Result<Path> endOf(const PreparedRun& run, const SessionSnapshot& now);

}  // namespace glissade::api
