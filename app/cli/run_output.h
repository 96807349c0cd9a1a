#pragma once

#include "app/cli/commands.h"

namespace glissade::cli {

/// Writes path and record as requested, reports the run, and returns the exit code. `stop` can end the difficulty
/// report.
int deliver(const PlanOptions& options, const LoadedScenario& scenario, const SessionSnapshot& ended,
            const StopToken& stop);

}  // namespace glissade::cli
