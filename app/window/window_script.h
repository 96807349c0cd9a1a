#pragma once

#include "app/window/workbench.h"

namespace glissade {

/// The script commands for actions, keys and the mouse over the 3D view, and pictures of the window.
void addWindowCommands(const Workbench& bench);

}  // namespace glissade
