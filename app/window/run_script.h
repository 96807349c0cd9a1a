#pragma once

#include "app/window/workbench.h"

namespace glissade {

/// The script commands about parameters, strategy, operator and the state of the run.
void addRunCommands(const Workbench& bench);

}  // namespace glissade
