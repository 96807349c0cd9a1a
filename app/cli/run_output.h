#pragma once

#include "app/cli/commands.h"

namespace glissade::cli {

/// Writes path and record as asked for, reports the run, and returns the process's exit code. The
/// difficulty report looks at the token.
int deliver(const PlanOptions& options, const LoadedScenario& scenario, const SessionSnapshot& end,
            const StopToken& stop);

}  // namespace glissade::cli
