#pragma once

#include "app/window/workbench.h"

namespace glissade {

class ArrangeController;

/// Script commands about arranging in the view.
void addArrangeCommands(const Workbench& bench, ArrangeController& arrange);

}  // namespace glissade
