#pragma once

#include "app/cli/plan_command.h"

namespace glissade::cli {

/// A session's configuration from scenario, options and (for replay) a run record. The options win
/// over the record, the record over the scenario.
struct RunSetup {
  SessionConfig config;
};
Result<RunSetup> setUpRun(const PlanOptions& options, const LoadedScenario& scenario);

}  // namespace glissade::cli
