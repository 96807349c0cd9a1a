#pragma once

#include "app/window/workbench.h"

namespace glissade {

class TimesController;

/// The commands about the times of the assembly and their table.
void addTimesCommands(const Workbench& bench, TimesController& times);

}  // namespace glissade
