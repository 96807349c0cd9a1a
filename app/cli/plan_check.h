#pragma once

#include "app/cli/check_command.h"

namespace glissade::cli {

/// glissade-cli check of an assembly plan: every step by the independent check, against the bodies that are there.
/// Exit code 0 valid, 1 invalid.
int runPlanCheck(const CheckOptions& options);

}  // namespace glissade::cli
