#pragma once

#include "widgets/workbench/workbench.h"

namespace glissade {

class SequenceController;

/// Adds the script commands about the assembly plan.
void addSequenceCommands(const Workbench& bench, SequenceController& sequence);

}  // namespace glissade
