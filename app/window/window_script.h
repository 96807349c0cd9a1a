#pragma once

#include "widgets/workbench/workbench.h"

namespace glissade {

/// Adds the script commands for actions, keys and the mouse over the 3D view, and for pictures of the window.
void addWindowCommands(const Workbench& bench);

}  // namespace glissade
