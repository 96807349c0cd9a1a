#pragma once

#include "app/window/workbench.h"

namespace glissade {

class DifficultyController;

/// The script commands about why no path was found.
void addDifficultyCommands(const Workbench& bench, DifficultyController& difficulty);

}  // namespace glissade
