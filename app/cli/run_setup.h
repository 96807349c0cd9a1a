#pragma once

#include "app/cli/plan_command.h"
#include "engine/session/session.h"

namespace glissade::cli {

/// The session that a run needs, from scenario, options and (for replay) a run record. The options
/// win over the record, the record over the scenario.
Result<std::unique_ptr<LockstepSession>> setUpRun(const PlanOptions& options, const LoadedScenario& scenario,
                                                  const StopToken& stop);

}  // namespace glissade::cli
