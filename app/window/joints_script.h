#pragma once

#include "app/window/workbench.h"

namespace glissade {

class JointsController;

/// Adds the script commands about joints. `joints` outlives the commands.
void addJointCommands(const Workbench& bench, JointsController& joints);

}  // namespace glissade
