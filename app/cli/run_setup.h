#pragma once

#include <vector>

#include "app/cli/plan_command.h"
#include "engine/scenario/run_record.h"

namespace glissade::cli {

/// What a run needs, from scenario, options and (for replay) a run record. The options win over the
/// record, the record over the scenario.
struct RunSetup {
  SessionConfig config;
  std::vector<RunRecord::ParameterChange> parameterChanges;  ///< of the record, ascending steps
};
Result<RunSetup> setUpRun(const PlanOptions& options, const LoadedScenario& scenario);

}  // namespace glissade::cli
